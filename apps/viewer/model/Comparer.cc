#include "model/Comparer.hh"

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

#include "measure/Distance.hh"
#include "measure/Monitor.hh"
#include "whittle/surface/errors.hh"
#include "whittle/surface/threads.hh"

namespace whittle::viewer {
namespace {

// How the work of a comparison is divided, in parts of all of it.
constexpr double kInspection = 0.25, kHeat = 0.3;

std::vector<float> distances(const std::vector<IndexedMesh::Point>& points, const measure::ClosestFace& to,
                             measure::Watch& watch, double work) {
  constexpr std::size_t kBlock = 2048;
  whittle::detail::Crew crew(std::thread::hardware_concurrency());
  std::vector<float> out(points.size());
  crew.each_range(points.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    if (watch.stopped()) return;
    for (std::size_t i = begin; i < end; ++i)
      out[i] = static_cast<float>(std::sqrt(to.closest(points[i]).squared_distance));
    watch.done(work * static_cast<double>(end - begin) / static_cast<double>(points.size()));
  });
  watch.check();
  return out;
}

}  // namespace

void Comparer::add_heat(const Outcome& outcome, measure::Watch& watch, Comparison& comparison) {
  const auto go_on = [&watch] { return watch.done(0); };
  if (model_ != outcome.model) {
    model_.reset();
    tree_ = std::make_unique<Tree>(outcome.model->mesh(), go_on);
    model_ = outcome.model;
  }
  const Tree result(outcome.mesh(), go_on);
  comparison.original_heat = distances(outcome.model->mesh().points, result.faces, watch, kHeat / 2);
  comparison.result_heat = distances(outcome.mesh().points, tree_->faces, watch, kHeat / 2);
  const auto& map = outcome.result.vertex_map;
  for (std::size_t v = 0; v < map.size(); ++v)
    comparison.result_heat[map[v]] = std::max(comparison.result_heat[map[v]], comparison.original_heat[v]);
  comparison.heat_top = quantile(comparison.result_heat, 0.995);
}

std::shared_ptr<const Comparison> Comparer::compare(const std::shared_ptr<const Outcome>& outcome,
                                                    const measure::Monitor& monitor) {
  auto comparison = std::make_shared<Comparison>();
  comparison->outcome = outcome;
  measure::Watch watch(monitor, 1);
  if (!watch.done(0)) return nullptr;
  comparison->inspection = inspect(outcome->mesh());
  comparison->histograms = histograms(outcome->model->inspection, &comparison->inspection);
  if (!watch.done(kInspection)) return nullptr;
  try {
    add_heat(*outcome, watch, *comparison);
    double before = 0;
    comparison->distance = measure::distance(outcome->model->mesh(), outcome->mesh(), {}, [&](double part) {
      return watch.done((1 - kInspection - kHeat) * (part - std::exchange(before, part)));
    });
  } catch (const measure::Cancelled&) {
    return nullptr;
  } catch (const InvalidMesh&) {  // no face of positive area: there is nothing to measure
    comparison->original_heat.assign(outcome->model->mesh().points.size(), 0);
    comparison->result_heat.assign(outcome->mesh().points.size(), 0);
  }
  return comparison;
}

}  // namespace whittle::viewer
