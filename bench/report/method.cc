#include <algorithm>
#include <map>

#include "papers/Verdict.hh"
#include "report/sections.hh"
#include "results/text.hh"

namespace whittle::bench {

std::string improvement_text(const std::optional<Figures>& f) {
  if (!f) return kNone;
  const char* const mark = f->certainty == Certainty::spread_exceeds_effect ? " ≈" : "";
  return spread_text(f->improvement, 1) + mark;
}

namespace {

/// The names, or how many there are where they would fill half a page.
std::string named(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 14;
  if (names.size() > kMost) return std::to_string(names.size()) + " sets";
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

std::vector<Block> warnings(const ExperimentResult& e) {
  std::vector<Block> blocks;
  std::vector<std::string> unclear, single, untimed;
  for (const SetResult& set : e.sets) {
    const std::string& name = set.definition.name;
    if (!set.note.empty()) blocks.push_back(Callout{name + ": " + set.note + "."});
    if (set.triangles > 0 && set.visits.size() < e.timing.repetitions) untimed.push_back(name);
    const auto f = figures(set, e);
    if (!f || set.definition.original()) continue;
    if (f->certainty == Certainty::spread_exceeds_effect) unclear.push_back(name);
    if (f->certainty == Certainty::one_repetition) single.push_back(name);
  }
  if (!unclear.empty())
    blocks.push_back(
        Callout{"The spread is larger than the effect (marked ≈): how much faster or slower than the "
                "original these sets are "
                "drawn cannot be told from this run: " +
                named(unclear) + "."});
  if (!single.empty())
    blocks.push_back(Callout{"Timed once only, so nothing is known of the spread: " + named(single) + "."});
  if (!untimed.empty())
    blocks.push_back(Callout{"Fewer than " + std::to_string(e.timing.repetitions) +
                             " repetitions are there for: " + named(untimed) + "."});
  return blocks;
}

Section verdict_section(const Results& results) {
  Section section{"verdicts", "The papers' claims", {}};
  Table table{"", {"Claim", "Source", "Verdict", "Measured", "Ours / theirs"}, {}, 4};
  std::map<Word, int> counts;
  std::vector<std::string> reasons;
  for (const Verdict& v : verdicts(results)) {
    table.rows.push_back(
        {v.claim, v.source, to_string(v.word), v.measured, v.ratio.empty() ? kNone : v.ratio});
    ++counts[v.word];
    if (!v.why.empty() && std::count(reasons.begin(), reasons.end(), v.why) == 0) reasons.push_back(v.why);
  }
  if (table.rows.empty()) {
    section.blocks.push_back(Paragraph{"Nothing has been timed yet."});
    return section;
  }
  std::string summary = "Of " + std::to_string(table.rows.size()) + " claims – ";
  for (const auto& [word, count] : counts)
    summary += (word == counts.begin()->first ? "" : ", ") + to_string(word) + " " + std::to_string(count);
  section.blocks.push_back(Paragraph{
      summary +
      ". A claim holds if the measured figure is within a quarter of it or its spread covers it; a spread "
      "larger than the effect leaves it undecided."});
  section.blocks.push_back(table);
  for (const auto& reason : reasons) section.blocks.push_back(Paragraph{reason + "."});
  return section;
}

Section method_section(const Results& r) {
  const Environment& e = r.environment;
  Section section{"method", "What ran, and how", {}};
  for (const auto& note : r.notes) section.blocks.push_back(Callout{note + "."});
  Table machine{"", {"", ""}, {}, 2};
  machine.rows = {
      {"Protocol", r.protocol + (r.starts > 1 ? ", in " + std::to_string(r.starts) + " starts" : "")},
      {"Renderer", e.gl_renderer + "; " + e.gl_vendor + "; OpenGL " + e.gl_version},
      {"Device", e.egl_device},
      {"Processor", e.cpu_model + ", " + std::to_string(e.cpu_threads) + " threads"},
      {"Build",
       e.compiler + ", " + e.build_type + ", commit " + e.commit + (e.commit_dirty ? " with changes" : "")},
      {"Begun", e.date_utc},
      {"Timed image", std::to_string(r.settings.width) + "x" + std::to_string(r.settings.height) +
                          " pixels, off-screen, one sample a pixel"}};
  for (const auto& experiment : r.experiments)
    machine.rows.push_back(
        {experiment.name, experiment.model.label + ", " + thousands(double(experiment.model.vertices)) +
                              " vertices, " + thousands(double(experiment.model.triangles)) + " triangles; " +
                              std::to_string(experiment.sets.size()) + " sets; frames " +
                              std::to_string(experiment.timing.frames_from) + " to " +
                              std::to_string(experiment.timing.frames_to) + " in one span; " +
                              std::to_string(experiment.timing.repetitions) + " repetitions"});
  section.blocks.push_back(machine);
  for (const auto& experiment : r.experiments)
    for (const auto& note : experiment.model.notes)
      section.blocks.push_back(Callout{experiment.name + ": " + note + "."});
  section.blocks.push_back(Paragraph{
      "Each repetition visits every set once, beginning with another set each time. A visit draws frames "
      "that warm up "
      "and then the timed frames in one span between two `glFinish`; a GL timer query runs over the same "
      "span, and both "
      "times are kept. The improvement, 100·(original / time − 1), is formed within a repetition against the "
      "original of that repetition. Shown are medians over the repetitions, with the smallest and the "
      "largest as error "
      "bars."});
  return section;
}

}  // namespace whittle::bench
