#include "papers/Papers.hh"

namespace whittle::bench::papers {

const std::vector<Computer>& computers() {
  static const std::vector<Computer> all = {{"PC 1", "NVIDIA GeForce GTX 1060", 27.29, 36743},
                                            {"PC 2", "Intel HD Graphics 4400", 81.29, 12302}};
  return all;
}

const std::vector<Algorithm>& algorithms() {
  static const std::vector<Algorithm> all = {{"VT", 30.32}, {"FAD", 25.76}, {"IVDD", 25.56},
                                             {"SS", 23.97}, {"VTD", 22.71}, {"FASS", 23.38}};
  return all;
}

std::optional<double> claimed_improvement(const std::string& algorithm) {
  for (const Algorithm& one : algorithms())
    if (one.name == algorithm) return one.improvement_percent;
  return std::nullopt;
}

const std::vector<Angle>& angles() {
  static const std::vector<Angle> all = {{"original", "original", 1521, 2904, 16.335},
                                         {"included-30", "> 30°", 1329, 2562, 15.894},
                                         {"included-60", "> 60°", 1373, 2574, 15.945},
                                         {"included-120", "> 120°", 1430, 2691, 16.139},
                                         {"included-150", "> 150°", 1486, 2832, 16.321}};
  return all;
}

}  // namespace whittle::bench::papers
