#include "papers/Verdict.hh"

#include <algorithm>
#include <cmath>

#include "papers/Papers.hh"
#include "results/Figures.hh"
#include "results/text.hh"

namespace whittle::bench {
namespace {

constexpr char kMore[] =
    "More than claimed: a software renderer's time falls nearly as the triangles do, while the paper's GPUs "
    "also have "
    "a cost for each frame that does not fall";

std::string why_word(Word word) {
  if (word == Word::more) return kMore;
  if (word == Word::undecided)
    return "Undecided: the spread over the repetitions is larger than the effect, or there is one repetition "
           "only";
  return "";
}

Verdict percent_claim(const std::string& source, const std::string& claim, double claimed,
                      const Summary& measured, std::size_t repetitions) {
  Verdict v{source,
            claim,
            spread_text(measured, 1) + " %",
            fixed(measured.median / claimed, 2),
            judge(claimed, measured, repetitions),
            ""};
  v.why = why_word(v.word);
  if (v.word == Word::undecided) v.ratio.clear();
  return v;
}

void judge_algorithms(const ExperimentResult& e, std::vector<Verdict>& all) {
  std::vector<std::pair<double, std::string>> ours;
  for (const auto& algorithm : papers::algorithms()) {
    const auto measured = mean_improvement(e, algorithm.name);
    if (!measured) continue;
    ours.emplace_back(measured->median, algorithm.name);
    all.push_back(percent_claim("Paper 1, conclusion",
                                algorithm.name + " raises the rendering speed by " +
                                    fixed(algorithm.improvement_percent, 2) + " % on average",
                                algorithm.improvement_percent, *measured, e.timing.repetitions));
  }
  if (ours.size() != papers::algorithms().size()) return;
  const auto best = std::max_element(ours.begin(), ours.end());
  std::string order;
  auto sorted = ours;
  std::sort(sorted.rbegin(), sorted.rend());
  for (const auto& [value, name] : sorted)
    order += (order.empty() ? "" : ", ") + name + " " + fixed(value, 0) + " %";
  all.push_back({"Paper 1, IV.IV", "of all algorithms VT improves the frame rate most", order, "",
                 best->second == "VT" ? Word::holds : Word::fails, ""});
  double sum = 0;
  for (const auto& [value, name] : ours) sum += value / static_cast<double>(ours.size());
  all.push_back({"Paper 1, IV.IV", "the six improve by about 26 % on average", fixed(sum, 1) + " %",
                 fixed(sum / 26, 2),
                 sum > 26 * 1.25   ? Word::more
                 : sum < 26 * 0.75 ? Word::less
                                   : Word::holds,
                 sum > 26 * 1.25 ? kMore : ""});
  const double low = sorted.back().first, high = sorted.front().first;
  all.push_back({"Paper 1, abstract", "rendering performance improves by 25 to 35 %",
                 fixed(low, 0) + " to " + fixed(high, 0) + " %", "",
                 low >= 25 && high <= 35 ? Word::holds
                 : low >= 25             ? Word::more
                                         : Word::fails,
                 low >= 25 ? "" : sorted.back().second + " stays below 25 %: it leaves the most triangles"});
}

void judge_parameters(const ExperimentResult& e, std::vector<Verdict>& all) {
  const auto removed = [&](const char* name) -> double {
    const SetResult* const set = find(e, name);
    return set == nullptr || !set->made ? -1 : static_cast<double>(e.sets.front().triangles - set->triangles);
  };
  const double fad30 = removed("fad-30"), fad150 = removed("fad-150");
  if (fad30 >= 0 && fad150 >= 0)
    all.push_back(
        {"Paper 1, Figure 13", "FAD at 30° and at 150° are two different simplifications",
         thousands(fad30) + " and " + thousands(fad150) + " triangles removed", "",
         fad150 > fad30 * 1.25 ? Word::holds : Word::fails,
         "FAD: a smooth scan has few vertices whose faces meet at more than 30°, and the ring lock, not the "
         "angle, bounds both"});
}

void judge_angles(const ExperimentResult& e, std::vector<Verdict>& all) {
  const auto& angles = papers::angles();
  bool falls = true;
  std::string counts;
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const SetResult* const set = find(e, angles[i].set + "-literal");
    if (set == nullptr || !set->made) return;
    const auto ours = static_cast<double>(e.sets.front().triangles) - static_cast<double>(set->triangles);
    const auto theirs = static_cast<double>(angles[0].triangles - angles[i].triangles) / 3;
    counts += (counts.empty() ? "" : ", ") + fixed(ours, 0);
    all.push_back({"Paper 2, Table 1",
                   angles[i].label + " removes " + fixed(theirs, 0) + " of 968 triangles (" +
                       fixed(3 * theirs, 0) + " indices)",
                   fixed(ours, 0) + " removed", fixed(ours / theirs, 2),
                   std::abs(ours / theirs - 1) <= 0.25 ? Word::holds
                   : ours > theirs                     ? Word::more
                                                       : Word::less,
                   ""});
    if (i > 1) {
      const SetResult* const before = find(e, angles[i - 1].set + "-literal");
      falls &= set->triangles >= before->triangles;
    }
  }
  all.push_back({"Paper 2, III.B", "the smaller the angle, the more is removed", counts + " triangles", "",
                 falls ? Word::holds : Word::fails, ""});
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const SetResult* const set = find(e, angles[i].set + "-literal");
    const auto f = figures(*set, e);
    if (!f) continue;
    const double claimed = improvement_percent(angles[0].milliseconds, angles[i].milliseconds);
    all.push_back(percent_claim("Paper 2, Table 1",
                                angles[i].label + " renders in " + fixed(angles[i].milliseconds, 3) +
                                    " ms instead of " + fixed(angles[0].milliseconds, 3) + ", " +
                                    fixed(claimed, 2) + " % faster",
                                claimed, f->improvement, f->repetitions));
  }
}

}  // namespace

std::string to_string(Word word) {
  const char* const words[] = {"holds", "more than claimed", "less than claimed", "does not hold",
                               "undecided"};
  return words[static_cast<int>(word)];
}

Word judge(double claimed, const Summary& measured, std::size_t repetitions) {
  if (certainty(measured, repetitions) != Certainty::clear) return Word::undecided;
  if (measured.median <= 0 && claimed > 0) return Word::fails;
  if (std::abs(measured.median - claimed) <= 0.25 * std::abs(claimed)) return Word::holds;
  if (measured.min <= claimed && claimed <= measured.max) return Word::holds;
  return measured.median > claimed ? Word::more : Word::less;
}

std::optional<Summary> mean_improvement(const ExperimentResult& e, const std::string& algorithm, Role role) {
  std::vector<double> sums;
  std::size_t sets = 0;
  for (const SetResult& set : e.sets) {
    if (set.definition.algorithm != algorithm || set.definition.role != role) continue;
    const auto f = figures(set, e);
    if (!f) return std::nullopt;
    if (sets++ == 0) sums.assign(f->improvement_percent.size(), 0.0);
    sums.resize(std::min(sums.size(), f->improvement_percent.size()));
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += f->improvement_percent[i];
  }
  if (sums.empty()) return std::nullopt;
  for (double& sum : sums) sum /= static_cast<double>(sets);
  return summarise(sums);
}

std::vector<Verdict> verdicts(const Results& results) {
  std::vector<Verdict> all;
  if (const ExperimentResult* const e = find(results, "paper1")) {
    judge_algorithms(*e, all);
    judge_parameters(*e, all);
  }
  if (const ExperimentResult* const e = find(results, "paper2")) judge_angles(*e, all);
  return all;
}

}  // namespace whittle::bench
