#include "results/Results.hh"

#include <algorithm>

namespace whittle::bench {

const ExperimentResult* find(const Results& results, const std::string& experiment) {
  const auto& all = results.experiments;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& e) { return e.name == experiment; });
  return found == all.end() ? nullptr : &*found;
}

const SetResult* find(const ExperimentResult& experiment, const std::string& set) {
  const auto& all = experiment.sets;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.definition.name == set; });
  return found == all.end() ? nullptr : &*found;
}

SetResult* find(ExperimentResult& experiment, const std::string& set) {
  return const_cast<SetResult*>(find(static_cast<const ExperimentResult&>(experiment), set));
}

}  // namespace whittle::bench
