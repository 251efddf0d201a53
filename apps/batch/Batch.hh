/// \file
/// Many meshes through one recipe, each in a process of its own.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "batch/Child.hh"
#include "batch/Items.hh"

namespace whittle::batch {

struct Order {
  std::vector<Item> items;
  std::filesystem::path out;             ///< of the results; what the batch remembers is in `.whittle` there
  std::string program;                   ///< `whittle`
  std::vector<std::string> arguments;    ///< of `whittle simplify`, without input and output
  std::vector<std::string> named_files;  ///< by the arguments; with other contents they are other arguments
  std::size_t jobs = 1;                  ///< at the same time
  Limits limits;                         ///< of each
  bool resume = false;                   ///< leave out what has been done with the same arguments
};

/// What became of one mesh.
// NOLINTNEXTLINE(bugprone-exception-escape): what moves a JSON value is noexcept, its assertions look otherwise
struct Outcome {
  enum class Status {
    done,
    missed,         ///< written, but the target was not reached
    failed,         ///< bad input, killed, out of time or memory: nothing written
    skipped,        ///< done before
    missed_before,  ///< written before, but the target was not reached
    elsewhere,      ///< claimed by another process
    unfinished      ///< the batch was interrupted
  };
  Status status = Status::unfinished;
  double seconds = 0;
  std::size_t faces_before = 0, faces_after = 0;
  std::string message;  ///< what the program said, or how it died
  /// As `simplify` reports them; null where there is no report
  nlohmann::ordered_json attribute_changes, charts, pieces, notes;
  bool logged = true;  ///< false: there was no room for its line in the log
};

std::string to_string(Outcome::Status status);

/// Called when something has happened: how many are done, in whatever way, and what with the last one.
using Report = std::function<void(std::size_t done, const Item& item, const Outcome& outcome)>;

/// Works through an order; other processes may work through the same one at the same time. What goes wrong with
/// an item ends with this item. A result takes its place when this process has seen that it is whole, so a child
/// that outlives a killed batch changes nothing. Claims of processes that do not live any more are taken over:
/// at once on their machine; on another after Claim::kLife without a change, for which this waits at the end.
/// Writes a line of JSON for each mesh to `out/.whittle/log/`, one file for each process.
/// \param interrupted  polled often; once true, running children are killed and no more are started.
/// \return an outcome for each item
/// \throw BatchError  the folder cannot be written to.
std::vector<Outcome> run(const Order& order, const Report& report, const std::function<bool()>& interrupted);

}  // namespace whittle::batch
