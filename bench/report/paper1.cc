#include "chart/BarChart.hh"
#include "papers/Papers.hh"
#include "papers/Verdict.hh"
#include "report/sections.hh"
#include "results/text.hh"

namespace whittle::bench {
namespace {

Table model_table(const ExperimentResult& e) {
  const auto row = [](const std::string& item, double theirs, double ours) {
    return std::vector<std::string>{item, thousands(theirs), thousands(ours), fixed(ours / theirs, 3)};
  };
  const auto vertices = double(e.model.vertices), triangles = double(e.model.triangles);
  return {"Table 2, the model",
          {"Item", "Paper", "Here", "Ours / theirs"},
          {row("Vertices", double(papers::kBunnyVertices), vertices),
           row("Vertex indices", double(papers::kBunnyIndices), 3 * triangles),
           row("Triangles", double(papers::kBunnyTriangles), triangles)},
          1};
}

Table original_table(const ExperimentResult& e) {
  Table table{"Table 3, the original drawn 1,000 times",
              {"Computer", "1,000 frames, ms", "Frames per second", "Time here / theirs"},
              {},
              1};
  const auto f = figures(e.sets.front(), e);
  const double ours = f ? 1000 * f->frame_mean_ms.median : 0;
  for (const auto& pc : papers::computers())
    table.rows.push_back({"Paper, " + pc.name + ", " + pc.gpu, fixed(pc.milliseconds, 2),
                          thousands(pc.frames_per_second), f ? fixed(ours / pc.milliseconds, 0) : kNone});
  table.rows.push_back(
      {"Here", f ? thousands(ours) : kNone, f ? fixed(f->frames_per_second.median, 1) : kNone, "1"});
  return table;
}

Table remaining_table(const ExperimentResult& e) {
  Table table{
      "Vertices and triangles that remain. The paper announces these counts but does not print them.",
      {"Set", "Vertices", "Triangles", "Removed, %", "Flipped faces", "Non-manifold edges", "Decimation, ms"},
      {},
      1};
  for (const SetResult& set : e.sets)
    table.rows.push_back({set.definition.label, thousands(double(set.vertices)),
                          thousands(double(set.triangles)),
                          fixed(100 - 100.0 * double(set.triangles) / double(e.model.triangles), 1),
                          std::to_string(set.flipped_faces), std::to_string(set.nonmanifold_edges),
                          set.definition.original() ? kNone : fixed(set.decimation_ms, 1)});
  return table;
}

Table time_table(const ExperimentResult& e) {
  Table table{"Times. The paper prints its improvement once for each algorithm, not for each set.",
              {"Set", "Frame, ms", "GL timer, ms", "Frames/s", "Frames/s gained", "Improvement, %",
               "Paper, %", "Ours / theirs"},
              {},
              1};
  for (const SetResult& set : e.sets) {
    const auto f = figures(set, e);
    const auto claim = papers::claimed_improvement(set.definition.algorithm);
    const bool compared = f && !set.definition.original();
    const double timed = double(e.timing.frames_timed());
    table.rows.push_back({set.definition.label, f ? spread_text(f->frame_mean_ms, 3) : kNone,
                          f && f->gl_total_ms ? fixed(f->gl_total_ms->median / timed, 3) : kNone,
                          f ? fixed(f->frames_per_second.median, 1) : kNone,
                          compared ? fixed(f->frames_per_second_gained.median, 1) : kNone,
                          compared ? improvement_text(f) : kNone, claim ? fixed(*claim, 2) : kNone,
                          compared && claim ? fixed(f->improvement.median / *claim, 2) : kNone});
  }
  return table;
}

/// The paper's x axis: parameters 1 to 4 of each algorithm.
template <typename Value>
chart::BarChart parameter_chart(const ExperimentResult& e, Value value) {
  chart::BarChart chart;
  for (const auto& algorithm : papers::algorithms()) {
    chart::BarGroup group{algorithm.name, {}, std::nullopt};
    for (const SetResult& set : e.sets) {
      if (set.definition.algorithm != algorithm.name || set.definition.role != Role::paper) continue;
      const auto f = figures(set, e);
      if (!f) continue;
      const Summary s = value(*f);
      group.bars.push_back({"P" + std::to_string(group.bars.size() + 1), s.median,
                            chart::Spread{s.min, s.max}, static_cast<int>(group.bars.size())});
    }
    if (!group.bars.empty()) chart.groups.push_back(group);
  }
  chart.legend = {"Parameter 1", "Parameter 2", "Parameter 3", "Parameter 4"};
  return chart;
}

void add_charts(Section& section, const ExperimentResult& e) {
  auto gained = parameter_chart(e, [](const Figures& f) { return f.frames_per_second_gained; });
  gained.title = "Frames per second gained by each set";
  gained.value_axis = "frames per second gained";
  section.blocks.push_back(
      Chart{"figure-9-10",
            "Figures 9 and 10: frames per second gained, parameters in the order of the table. The paper "
            "prints no numbers on its bars; its axes reach 14,000 (PC 1) and 7,000 (PC 2).",
            gained.svg()});
  auto improvement = parameter_chart(e, [](const Figures& f) { return f.improvement; });
  improvement.title = "Improvement in percent by each set, with the paper's mean for the algorithm";
  improvement.value_axis = "improvement, %";
  improvement.claim_name = "paper's mean";
  for (auto& group : improvement.groups) group.claim = papers::claimed_improvement(group.label);
  section.blocks.push_back(Chart{
      "figure-11-12",
      "Figures 11 and 12: improvement in %, error bars from the smallest to the largest repetition. "
      "The paper's axes span 12 to 28 % (PC 1) and 27 to 35 % (PC 2); the dashed lines are the means of its "
      "conclusion.",
      improvement.svg()});
}

void add_mean_table(Section& section, const ExperimentResult& e) {
  Table table{"Mean improvement over an algorithm's parameters, in %",
              {"Algorithm", "Paper", "Here", "Ours / theirs"},
              {},
              1};
  for (const auto& algorithm : papers::algorithms())
    if (const auto ours = mean_improvement(e, algorithm.name))
      table.rows.push_back({algorithm.name, fixed(algorithm.improvement_percent, 2), spread_text(*ours, 1),
                            fixed(ours->median / algorithm.improvement_percent, 2)});
  if (!table.rows.empty()) section.blocks.push_back(table);
}

}  // namespace

Section paper1_section(const ExperimentResult& e) {
  Section section{"paper1", "Paper 1: six algorithms on the bunny", warnings(e)};
  section.blocks.push_back(model_table(e));
  section.blocks.push_back(original_table(e));
  section.blocks.push_back(
      Paragraph{"1,000 frames in 27.29 ms are 36,643 frames a second; the paper prints 36,743."});
  section.blocks.push_back(remaining_table(e));
  section.blocks.push_back(time_table(e));
  add_mean_table(section, e);
  add_charts(section, e);
  const SetResult& original = e.sets.front();
  if (!original.pictures.whole.empty())
    section.blocks.push_back(
        Gallery{"Figure 8: panorama and detail of the original",
                {{original.pictures.whole, "Panorama"}, {original.pictures.detail, "Detail"}},
                true});
  Gallery ears{"Figure 13: the ears, all sets", {}, false};
  for (const SetResult& set : e.sets)
    if (!set.pictures.detail.empty()) ears.pictures.push_back({set.pictures.detail, set.definition.label});
  if (!ears.pictures.empty()) section.blocks.push_back(ears);
  return section;
}

}  // namespace whittle::bench
