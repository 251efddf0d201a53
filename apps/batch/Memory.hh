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
  /// \throw files::FileError  a file that the options name cannot be read.
  explicit Memory(const Order& order);

  std::filesystem::path claim(const Item& item) const { return folder_ / "claims" / item.name; }

  /// Where the program is to write its result, and its JSON.
  /// \{
  std::filesystem::path result(const Item& item) const;
  std::filesystem::path report(const Item& item) const;
  /// \}

  /// Takes away what a process has left of its work on an item. \param process  its process_name()
  void forget_work(const Item& item, const std::string& process) const;

  /// What the input is now: its size and the time of its last change.
  std::string input_stamp(const Item& item) const;

  /// Whether the result is there, made with the same arguments from the same input; fills in its counts. A
  /// result that has taken the place of its input is known by its content.
  bool knows(const Item& item, Outcome& outcome) const;

  /// Remembers that it is done, then puts the result in its place; fills in its counts. In this order no one
  /// ever takes a result for an input.
  /// \throw files::FileError  no room, …
  void keep(const Item& item, const std::string& input_stamp, Outcome& outcome) const;

  /// Adds a line to this process's log.
  /// \return whether there was room
  bool log(const Item& item, const Outcome& outcome) const;

 private:
  std::filesystem::path done(const Item& item) const { return folder_ / "done" / (item.name + ".json"); }
  std::filesystem::path work(const Item& item, const std::string& process, const char* extension) const;

  const Order& order_;
  std::filesystem::path folder_, log_;
  std::string arguments_;  ///< a hash of them, and of the contents of the files that they name
};

}  // namespace whittle::batch
