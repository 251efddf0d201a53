#include "chart/BarChart.hh"
#include "papers/Papers.hh"
#include "report/sections.hh"
#include "results/text.hh"

namespace whittle::bench {
namespace {

void add_row(Table& table, const ExperimentResult& e, const papers::Angle& angle, const SetResult& set,
             const std::string& reading) {
  const auto& base = papers::angles().front();
  const auto f = figures(set, e);
  const double theirs_removed = double(base.triangles - angle.triangles) / 3;
  const double ours_removed = double(e.sets.front().triangles) - double(set.triangles);
  const bool original = set.definition.original();
  const double claimed = improvement_percent(base.milliseconds, angle.milliseconds);
  table.rows.push_back({angle.label, reading, thousands(double(angle.vertices) / 3),
                        thousands(double(set.vertices)), thousands(double(angle.triangles) / 3),
                        thousands(double(set.triangles)), original ? kNone : fixed(theirs_removed, 0),
                        original ? kNone : fixed(ours_removed, 0),
                        original ? kNone : fixed(ours_removed / theirs_removed, 2),
                        fixed(angle.milliseconds, 3), f ? fixed(f->frame_mean_ms.median, 4) : kNone,
                        original ? kNone : fixed(claimed, 2), original ? kNone : improvement_text(f)});
}

}  // namespace

Section paper2_section(const ExperimentResult& e) {
  Section section{"paper2", "Paper 2: surface angle on Suzanne", warnings(e)};
  section.blocks.push_back(Paragraph{
      "The paper's 1,521 vertices and 2,904 triangles are 3·507 coordinates and 3·968 indices of Suzanne, so "
      "its counts "
      "are divided by three here. “By the words”: all pairs of faces are compared, removed vertices share no "
      "ring vertex, the fan starts at the lexicographically largest vertex. Defaults: faces that share an "
      "edge are "
      "compared, the ring is locked, and the fan starts where the worst triangle is best."});
  Table table{"Table 1, results. Counts in vertices and triangles; p: paper, h: here.",
              {"Angle", "Reading", "Vertices p", "h", "Triangles p", "h", "Removed p", "h", "Ours / theirs",
               "Time p, ms", "Frame h, ms", "Improvement p, %", "h, %"},
              {},
              2};
  for (const auto& angle : papers::angles()) {
    if (const SetResult* const set = find(e, angle.set))
      add_row(table, e, angle, *set, set->definition.original() ? "" : "defaults");
    if (const SetResult* const set = find(e, angle.set + "-literal"))
      add_row(table, e, angle, *set, "by the words");
  }
  section.blocks.push_back(table);

  chart::BarChart chart;
  chart.title = "Triangles of Suzanne removed at each angle: paper, by the words, defaults";
  chart.value_axis = "triangles removed";
  chart.legend = {"Paper 2", "here, by the words", "here, defaults"};
  chart.height = 320;
  for (const auto& angle : papers::angles()) {
    const SetResult *const words = find(e, angle.set + "-literal"), *const ours = find(e, angle.set);
    if (words == nullptr || ours == nullptr) continue;
    const double all = double(e.sets.front().triangles);
    const double theirs = double(papers::angles().front().triangles - angle.triangles) / 3;
    chart.groups.push_back({angle.label,
                            {{"", theirs, std::nullopt, 0},
                             {"", all - double(words->triangles), std::nullopt, 1},
                             {"", all - double(ours->triangles), std::nullopt, 2}},
                            std::nullopt});
  }
  if (!chart.groups.empty())
    section.blocks.push_back(Chart{"paper2-removed", "Triangles removed at each angle.", chart.svg()});

  Gallery pictures{
      "Figures 4 to 8: the original and the four angles, by the words and with the defaults", {}, false};
  for (const SetResult& set : e.sets)
    if (!set.pictures.whole.empty()) pictures.pictures.push_back({set.pictures.whole, set.definition.label});
  if (!pictures.pictures.empty()) section.blocks.push_back(pictures);
  return section;
}

}  // namespace whittle::bench
