#include <algorithm>
#include <optional>

#include "chart/ScatterChart.hh"
#include "report/sections.hh"
#include "results/text.hh"

namespace whittle::bench {
namespace {

/// How long a frame of a set takes, or how long the set took to make; in milliseconds, none if unknown.
using Time = std::optional<double> (*)(const SetResult& set, const ExperimentResult& e);

std::optional<double> frame_time(const SetResult& set, const ExperimentResult& e) {
  const auto f = figures(set, e);
  if (!f) return std::nullopt;
  return f->frame_mean_ms.median;
}

std::optional<double> decimation_time(const SetResult& set, const ExperimentResult& /*e*/) {
  if (!(set.decimation_ms > 0)) return std::nullopt;
  return set.decimation_ms;
}

/// A point of the scatter charts, with the value of `error`.
template <typename Error>
void add_point(chart::ScatterSeries& series, const SetResult& set, const ExperimentResult& e, Time time,
               Error error) {
  const auto ms = time(set, e);
  if (!ms || !set.fidelity) return;
  const double y = error(*set.fidelity), x = *ms;
  if (y > 0)
    series.points.push_back({x, y,
                             set.definition.label + ": " + fixed(x, 3) + " ms, " + short_number(y) + ", " +
                                 thousands(double(set.triangles)) + " triangles"});
}

template <typename Error>
chart::ScatterChart tradeoff_chart(const ExperimentResult& e, Time time, Error error) {
  chart::ScatterChart chart;
  chart.x_axis = time == frame_time ? "time of a frame, ms (left is faster)" : "time of the decimation, ms";
  if (time == decimation_time) chart.x_scale = chart::Scale::logarithmic;
  chart.y_scale = chart::Scale::logarithmic;
  // From many triangles to few, which is the order of a threshold.
  std::vector<const SetResult*> sets;
  for (const SetResult& set : e.sets)
    if (set.definition.role == Role::curve || set.definition.role == Role::peer) sets.push_back(&set);
  for (const SetResult* const set : sets) {
    const std::string& name = set->definition.algorithm;
    if (std::none_of(chart.series.begin(), chart.series.end(), [&](const auto& s) { return s.name == name; }))
      chart.series.push_back({name, {}, true});
  }
  std::stable_sort(sets.begin(), sets.end(),
                   [](const auto* a, const auto* b) { return a->triangles > b->triangles; });
  for (auto& series : chart.series)
    for (const SetResult* const set : sets)
      if (set->definition.algorithm == series.name) add_point(series, *set, e, time, error);
  chart.series.erase(std::remove_if(chart.series.begin(), chart.series.end(),
                                    [](const auto& s) { return s.points.empty(); }),
                     chart.series.end());
  return chart;
}

std::vector<std::string> peer_row(const SetResult& set, const ExperimentResult& e, const std::string& label) {
  const auto f = figures(set, e);
  const auto percent = [&](double length) { return fixed(100 * length / e.model.mean_edge, 2); };
  std::vector<std::string> cells = {label, thousands(double(set.triangles)), fixed(set.decimation_ms, 1)};
  if (set.fidelity)
    for (const auto& cell :
         {percent(set.fidelity->rms), percent(set.fidelity->max), fixed(set.fidelity->normal_mean_degrees, 1),
          fixed(set.fidelity->quality_mean, 3), fixed(set.fidelity->psnr_db, 1),
          fixed(set.fidelity->ssim, 4)})
      cells.push_back(cell);
  else
    cells.resize(cells.size() + 6, kNone);
  cells.push_back(f ? spread_text(f->frame_mean_ms, 3) : kNone);
  cells.push_back(improvement_text(f));
  return cells;
}

}  // namespace

Section tradeoff_section(const ExperimentResult& e) {
  Section section{"tradeoff", "Error against frame time", warnings(e)};
  section.blocks.push_back(Paragraph{
      "Each algorithm is a curve over its threshold (VT: over its passes), the other simplifiers "
      "over the triangle "
      "counts of Whittle's sets. By error: the same algorithm with the cheapest merges first and "
      "places by quadrics. Refitted: its vertices moved at the end to where the faces fit the original "
      "best. Lower and further to the left is better. Rest the mouse on a "
      "point for its set."});
  const auto rms_of = [&](const Fidelity& f) { return 100 * f.rms / e.model.mean_edge; };
  auto rms = tradeoff_chart(e, frame_time, rms_of);
  rms.title = "RMS error of each set against the time of a frame, one curve an algorithm";
  rms.y_axis = "RMS error, % of the mean edge";
  if (rms.series.empty()) return section;
  section.blocks.push_back(
      Chart{"error-frame-time", "Two-sided RMS error against the time of a frame.", rms.svg()});
  auto cost = tradeoff_chart(e, decimation_time, rms_of);
  cost.title = "RMS error of each set against the time of its decimation, one curve an algorithm";
  cost.y_axis = rms.y_axis;
  section.blocks.push_back(Chart{
      "error-decimation-time", "Two-sided RMS error against the time that the decimation took.", cost.svg()});
  auto ssim = tradeoff_chart(e, frame_time, [](const Fidelity& f) { return 1 - f.ssim; });
  ssim.title = "Image difference of each set against the time of a frame";
  ssim.y_axis = "1 − SSIM";
  section.blocks.push_back(Chart{
      "image-frame-time", "Difference of the pictures, 1 − SSIM, against the time of a frame.", ssim.svg()});
  return section;
}

Section peer_section(const ExperimentResult& e) {
  Section section{"peers", "Other simplifiers at the same triangle count", {}};
  section.blocks.push_back(
      Paragraph{"Each block begins with one of Whittle's sets; the others were brought to its number of "
                "triangles. Decimation is "
                "the simplifier alone, without reading files: Whittle's bulk executor and planner on flat "
                "arrays, OpenMesh's "
                "DecimaterT with ModQuadricT from Debian's library (built with assertions), meshoptimizer's "
                "meshopt_simplify, Whittle's quadric with a refit, Whittle's mq, CGAL's "
                "edge_collapse with Lindstrom and Turk's policies. RMS and max are in % of the mean edge."});
  Table table{"The same number of triangles, by different means",
              {"Simplifier", "Triangles", "Decimation, ms", "RMS", "Max", "Normals, °", "Quality", "PSNR, dB",
               "SSIM", "Frame, ms", "Improvement, %"},
              {},
              1};
  std::vector<std::string> bases;
  for (const SetResult& set : e.sets)
    if (set.definition.role == Role::peer &&
        std::find(bases.begin(), bases.end(), set.definition.compared_with) == bases.end())
      bases.push_back(set.definition.compared_with);
  for (const std::string& name : bases) {
    const SetResult* const base = find(e, name);
    if (base == nullptr) continue;
    table.rows.push_back(peer_row(*base, e, "Whittle " + base->definition.label));
    for (const SetResult& set : e.sets)
      if (set.definition.role == Role::peer && set.definition.compared_with == name)
        table.rows.push_back(peer_row(set, e, "… " + set.definition.label));
  }
  if (!table.rows.empty()) section.blocks.push_back(table);
  Gallery gallery{"The ears and the error, as many triangles as VT leaves: the other simplifiers", {}, false};
  for (const SetResult& set : e.sets)
    if (set.definition.role == Role::peer && set.definition.compared_with == "vt" &&
        !set.pictures.heat.empty()) {
      gallery.pictures.push_back({set.pictures.detail, set.definition.label});
      gallery.pictures.push_back({set.pictures.heat, set.definition.label + ", error"});
    }
  if (!gallery.pictures.empty()) section.blocks.push_back(gallery);
  return section;
}

Section cache_section(const ExperimentResult& e) {
  Section section{"cache", "The order of the triangles", {}};
  section.blocks.push_back(
      Paragraph{"The papers draw the triangles in the order in which decimation leaves them. Here the same "
                "meshes stand beside "
                "themselves after meshoptimizer's vertex-cache optimisation. Misses: vertices fetched for "
                "each triangle by a "
                "first-in-first-out cache of 16; that is what a GPU gains, and a software renderer with "
                "another cache need not."});
  Table table{"",
              {"Set", "Misses as decimated", "optimised", "Frame as decimated, ms", "optimised, ms",
               "Improvement as decimated, %", "optimised, %"},
              {},
              1};
  for (const SetResult& set : e.sets) {
    const SetResult* const base = find(e, set.definition.compared_with);
    if (set.definition.role != Role::cache || base == nullptr) continue;
    const auto before = figures(*base, e), after = figures(set, e);
    table.rows.push_back(
        {base->definition.label, fixed(base->cache_misses_per_triangle, 3),
         fixed(set.cache_misses_per_triangle, 3), before ? spread_text(before->frame_mean_ms, 3) : kNone,
         after ? spread_text(after->frame_mean_ms, 3) : kNone,
         base->definition.original() ? kNone : improvement_text(before), improvement_text(after)});
  }
  section.blocks.push_back(table);
  return section;
}

}  // namespace whittle::bench
