/// \file
/// What a batch remembers between runs and shares between processes: the folder `.whittle` among the results.
#pragma once

#include <filesystem>
#include <string>

#include "batch/Batch.hh"

namespace whittle::batch {

class Memory {
 public:
  /// \throw std::filesystem::filesystem_error  the folders cannot be made.
  explicit Memory(const Order& order);

  std::filesystem::path claim(const Item& item) const { return folder_ / "claims" / item.name; }

  /// Where the program is to write its JSON.
  std::filesystem::path work(const Item& item) const;
  void forget_work(const Item& item) const;

  /// Whether the result is there, made with the same arguments from the same input; fills in its counts.
  bool knows(const Item& item, Outcome& outcome) const;

  /// Remembers that it is done; fills in its counts.
  void keep(const Item& item, Outcome& outcome) const;

  /// Adds a line to this process's log.
  void log(const Item& item, const Outcome& outcome) const;

 private:
  std::filesystem::path done(const Item& item) const { return folder_ / "done" / (item.name + ".json"); }
  std::string key(const Item& item) const;

  const Order& order_;
  std::filesystem::path folder_, log_;
};

}  // namespace whittle::batch
