/// \file
/// The words that stand for enumerations and the schema in results.json.
#pragma once

#include <string>

#include "results/Figures.hh"
#include "results/Results.hh"

namespace whittle::bench {

constexpr char kSchema[] = "whittle-bench";
constexpr int kSchemaVersion = 2;

inline std::string to_string(Role role) {
  const char* const names[] = {"paper", "literal", "curve", "peer", "cache"};
  return names[static_cast<int>(role)];
}

inline std::string to_string(Certainty certainty) {
  const char* const names[] = {"clear", "spread_exceeds_effect", "one_repetition"};
  return names[static_cast<int>(certainty)];
}

}  // namespace whittle::bench
