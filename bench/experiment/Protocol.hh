/// \file
/// How long a run takes: the figures behind --quick and --paper.
#pragma once

#include <string>
#include <vector>

#include "results/Results.hh"

namespace whittle::bench {

/// The experiments in the order in which they run.
constexpr const char* kExperiments[] = {"paper1", "paper2", "beyond"};

struct Protocol {
  std::string name;
  Settings settings;
  Timing paper1, paper2, beyond;

  Timing& timing(const std::string& experiment);
};

/// Frames 100 to 1,100 of Paper 1 and 100 to 200 of Paper 2, ten repetitions, as the papers have them. About
/// twenty minutes on software GL with two cores.
Protocol paper_protocol();

/// The same sets with fewer frames and repetitions: about four minutes there.
Protocol quick_protocol();

}  // namespace whittle::bench
