/// \file
/// The sets of the experiment: what is drawn against the original.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace whittle::bench {

/// One set. The original has no recipe.
struct SetDefinition {
  std::string name;         ///< on the command line and in file names
  std::string paper_label;  ///< as under the paper's picture of the ears
  std::string recipe;       ///< a module specification, lengths in the units of Stanford's bunny
};

/// The fourteen sets of Paper 1 in the order of its Figure 13, the original first.
const std::vector<SetDefinition>& paper_sets();

/// The sets of these names in the paper's order, and always the original, which the others are compared with.
/// All sets where `names` is empty or has "all" in it.
/// \throw std::invalid_argument  there is no set of such a name; `what()` lists those there are.
std::vector<SetDefinition> choose_sets(const std::vector<std::string>& names);

}  // namespace whittle::bench
