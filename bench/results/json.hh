/// \file
/// results.json; docs/benchmark.md describes its fields.
#pragma once

#include <stdexcept>
#include <string>

#include "results/Results.hh"

namespace whittle::bench {

/// A text that is no result of whittle-bench; `what()` is one line that names the place.
class ResultsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The stored fields, and beside them the figures formed from them, for other programs' sake.
std::string json_text(const Results& results);

/// Reads the stored fields back; the formed ones are ignored.
/// \throw ResultsError
Results parse_results(const std::string& text);

}  // namespace whittle::bench
