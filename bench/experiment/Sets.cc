#include "experiment/Sets.hh"

#include <algorithm>

namespace whittle::bench {

const std::vector<SetDefinition>& paper_sets() {
  static const std::vector<SetDefinition> sets = {
      {"original", "Original", ""},
      {"fad-30", "FAD (Included angle <= 30°)", "fad:angle=30"},
      {"fad-150", "FAD (Included angle <= 150°)", "fad:angle=150"},
      {"ivdd-0.0011", "IVDD (Distance = 0.0011)", "ivdd:distance=0.0011"},
      {"ivdd-0.0013", "IVDD (Distance = 0.0013)", "ivdd:distance=0.0013"},
  };
  return sets;
}

std::vector<SetDefinition> choose_sets(const std::vector<std::string>& names) {
  const auto& all = paper_sets();
  if (names.empty()) return all;

  const auto is_unknown = [&](const std::string& name) {
    return std::none_of(all.begin(), all.end(), [&](const auto& set) { return set.name == name; });
  };
  const auto unknown = std::find_if(names.begin(), names.end(), is_unknown);
  if (unknown != names.end()) {
    std::string known;
    for (const auto& set : all) known.append(known.empty() ? "" : ", ").append(set.name);
    throw std::invalid_argument("there is no set \"" + *unknown + "\"; there are " + known);
  }

  std::vector<SetDefinition> chosen;
  for (const auto& set : all) {
    if (set.recipe.empty() || std::count(names.begin(), names.end(), set.name) > 0) chosen.push_back(set);
  }
  return chosen;
}

}  // namespace whittle::bench
