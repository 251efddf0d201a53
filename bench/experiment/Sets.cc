#include "experiment/Sets.hh"

#include <algorithm>

namespace whittle::bench {

const std::vector<SetDefinition>& paper_sets() {
  static const std::vector<SetDefinition> sets = {
      {"original", "Original", ""},
      {"vt", "VT", "vt"},
      {"fad-30", "FAD (Included angle <= 30°)", "fad:angle=30"},
      {"fad-150", "FAD (Included angle <= 150°)", "fad:angle=150"},
      {"ivdd-0.0011", "IVDD (Distance = 0.0011)", "ivdd:distance=0.0011"},
      {"ivdd-0.0013", "IVDD (Distance = 0.0013)", "ivdd:distance=0.0013"},
      {"ss-0.0012", "SS (Radius = 0.0012)", "ss:radius=0.0012"},
      {"ss-0.0014", "SS (Radius = 0.0014)", "ss:radius=0.0014"},
      {"vtd-0.0011", "VTD (Distance = 0.0011)", "vtd:distance=0.0011"},
      {"vtd-0.0013", "VTD (Distance = 0.0013)", "vtd:distance=0.0013"},
      {"fass-0.0012-30", "FASS (Radius = 0.0012 & angle < 30°)", "fass:radius=0.0012,angle=30"},
      {"fass-0.0012-150", "FASS (Radius = 0.0012 & angle < 150°)", "fass:radius=0.0012,angle=150"},
      {"fass-0.0014-30", "FASS (Radius = 0.0014 & angle < 30°)", "fass:radius=0.0014,angle=30"},
      {"fass-0.0014-150", "FASS (Radius = 0.0014 & angle < 150°)", "fass:radius=0.0014,angle=150"},
  };
  return sets;
}

std::vector<SetDefinition> choose_sets(const std::vector<std::string>& names) {
  const auto& all = paper_sets();
  const auto is_unknown = [&](const std::string& name) {
    return name != "all" &&
           std::none_of(all.begin(), all.end(), [&](const auto& set) { return set.name == name; });
  };
  const auto unknown = std::find_if(names.begin(), names.end(), is_unknown);
  if (unknown != names.end()) {
    std::string known = "all";
    for (const auto& set : all) known.append(", ").append(set.name);
    throw std::invalid_argument("there is no set \"" + *unknown + "\"; there are " + known);
  }
  if (names.empty() || std::count(names.begin(), names.end(), "all") > 0) return all;

  std::vector<SetDefinition> chosen;
  for (const auto& set : all) {
    if (set.recipe.empty() || std::count(names.begin(), names.end(), set.name) > 0) chosen.push_back(set);
  }
  return chosen;
}

}  // namespace whittle::bench
