#include "model/Comparer.hh"

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

#include "whittle/errors.hh"
#include "whittle/parallel.hh"

namespace whittle::viewer {
namespace {

std::vector<float> distances(const std::vector<IndexedMesh::Point>& points, const measure::ClosestFace& to) {
  std::vector<float> out(points.size());
  for_each_part(points.size(), std::thread::hardware_concurrency(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      out[i] = static_cast<float>(std::sqrt(to.closest(points[i]).squared_distance));
  });
  return out;
}

}  // namespace

bool Comparer::add_heat(const Outcome& outcome, const std::function<bool()>& wanted, Comparison& comparison) {
  if (model_ != outcome.model) {
    tree_ = std::make_unique<Tree>(outcome.model->mesh());
    model_ = outcome.model;
  }
  if (!wanted()) return false;
  const Tree result(outcome.mesh());
  if (!wanted()) return false;
  comparison.original_heat = distances(outcome.model->mesh().points, result.faces);
  if (!wanted()) return false;
  comparison.result_heat = distances(outcome.mesh().points, tree_->faces);
  const auto& map = outcome.result.vertex_map;
  for (std::size_t v = 0; v < map.size(); ++v)
    comparison.result_heat[map[v]] = std::max(comparison.result_heat[map[v]], comparison.original_heat[v]);
  comparison.heat_top = quantile(comparison.result_heat, 0.995);
  return true;
}

std::shared_ptr<const Comparison> Comparer::compare(std::shared_ptr<const Outcome> outcome,
                                                    const std::function<bool()>& wanted) {
  auto comparison = std::make_shared<Comparison>();
  comparison->outcome = outcome;
  if (!wanted()) return nullptr;
  comparison->inspection = inspect(outcome->mesh());
  if (!wanted()) return nullptr;
  try {
    if (!add_heat(*outcome, wanted, *comparison) || !wanted()) return nullptr;
    comparison->distance = measure::distance(outcome->model->mesh(), outcome->mesh());
  } catch (const InvalidMesh&) {  // no face of positive area: there is nothing to measure
    comparison->original_heat.assign(outcome->model->mesh().points.size(), 0);
    comparison->result_heat.assign(outcome->mesh().points.size(), 0);
  }
  return comparison;
}

}  // namespace whittle::viewer
