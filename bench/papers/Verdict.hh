/// \file
/// A claim, what was measured, and a plain word on it.
#pragma once

#include <string>
#include <vector>

#include "results/Results.hh"
#include "results/Statistics.hh"

namespace whittle::bench {

enum class Word { holds, more, less, fails, undecided };
std::string to_string(Word word);

struct Verdict {
  std::string source;    ///< "Paper 1, Section V"
  std::string claim;     ///< in the paper's words or near them
  std::string measured;  ///< Whittle's figures
  std::string ratio;     ///< ours by the paper's; empty where that has no meaning
  Word word = Word::undecided;
  std::string why;  ///< one sentence, where the word alone could mislead
};

/// Compares a measured percentage with a claimed one: it holds within a quarter of the claim or where the
/// claim lies within the spread; a spread larger than the effect decides nothing.
Word judge(double claimed, const Summary& measured, std::size_t repetitions);

/// Every claim of the papers that the results can say something about.
std::vector<Verdict> verdicts(const Results& results);

/// The mean of an algorithm's improvements over its sets, in each repetition; then median and spread. None
/// where a set has not been timed.
std::optional<Summary> mean_improvement(const ExperimentResult& experiment, const std::string& algorithm,
                                        Role role = Role::paper);

}  // namespace whittle::bench
