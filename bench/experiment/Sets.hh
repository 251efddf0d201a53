/// \file
/// The sets of the experiments: what is drawn against the original.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "results/Results.hh"

namespace whittle::bench {

/// The fourteen sets of Paper 1 in the order of its Figure 13, the original first.
const std::vector<SetDefinition>& paper1_sets();

/// The original and the four angles of Paper 2, each with Whittle's defaults and by the paper's words.
const std::vector<SetDefinition>& paper2_sets();

/// What goes beyond the papers, on Paper 1's model: each algorithm over its threshold, the readings by the
/// papers' literal words, other simplifiers at the same triangle count, and the order for the vertex cache.
/// \param peers  names and labels of the simplifiers there are
struct PeerName {
  std::string name, label;
};
std::vector<SetDefinition> beyond_sets(const std::vector<PeerName>& peers);

/// The sets of Paper 1 of these names in the paper's order, and always the original, which the others are
/// compared with. All sets where `names` is empty or has "all" in it.
/// \throw std::invalid_argument  there is no set of such a name; `what()` lists those there are.
std::vector<SetDefinition> choose_sets(const std::vector<std::string>& names);

}  // namespace whittle::bench
