#include "model/Model.hh"

#include <algorithm>
#include <utility>

namespace whittle::viewer {

Inspection inspect(const IndexedMesh& mesh) {
  Inspection out;
  out.facts = measure::facts(mesh);
  const std::vector<Edge> edges = edge_table(mesh);
  out.edges = EdgeSets(edges);
  for (const Quantity quantity : kQuantities)
    out.values[static_cast<std::size_t>(quantity)] = values_of(quantity, mesh, edges);
  return out;
}

std::array<HistogramPair, 3> histograms(const Inspection& original, const Inspection* result) {
  std::array<HistogramPair, 3> all;
  for (const Quantity quantity : kQuantities)
    all[static_cast<std::size_t>(quantity)] =
        histograms(quantity, original.of(quantity), result ? &result->of(quantity) : nullptr);
  return all;
}

std::shared_ptr<const Model> load_model(const std::string& path) {
  auto model = std::make_shared<Model>();
  model->path = path;
  model->file = files::read_mesh(path);
  if (model->mesh().triangles.empty()) throw files::FileError(path + ": the mesh has no faces to show");
  model->scale = recipe::measure_scale(model->mesh());
  model->inspection = inspect(model->mesh());
  model->histograms = histograms(model->inspection, nullptr);
  model->arrays.emplace(model->mesh());
  return model;
}

double Outcome::faces_removed() const {
  const auto before = static_cast<double>(model->mesh().triangles.size());
  return before > 0 ? 1 - static_cast<double>(mesh().triangles.size()) / before : 0;
}

namespace {

std::shared_ptr<Outcome> finished(std::shared_ptr<const Model> model, const recipe::Recipe& recipe,
                                  recipe::Result result) {
  auto outcome = std::make_shared<Outcome>();
  outcome->result = std::move(result);
  if (model->file.single_precision)
    for (auto& point : outcome->result.mesh.points) point = point.cast<float>().cast<double>();
  outcome->milliseconds = 1e3 * outcome->result.seconds();
  outcome->arrays.emplace(outcome->mesh());
  outcome->recipe = recipe;
  outcome->model = std::move(model);
  return outcome;
}

}  // namespace

std::shared_ptr<const Outcome> make_outcome(std::shared_ptr<const Model> model, const recipe::Recipe& recipe,
                                            const recipe::Monitor& monitor) {
  recipe::Result result = recipe::run(model->mesh(), recipe, monitor, model->givens());
  return finished(std::move(model), recipe, std::move(result));
}

std::shared_ptr<const Outcome> make_level(std::shared_ptr<const Model> model, const recipe::Recipe& recipe,
                                          Levels& levels, const recipe::Monitor& monitor) {
  const bool planned = levels.has_value();
  if (!planned) levels.emplace(model->mesh(), model->givens(), monitor);
  const auto faces = *recipe.target.ratio * static_cast<double>(model->mesh().triangles.size());
  recipe::Result result = levels->at(std::max<std::size_t>(1, static_cast<std::size_t>(faces)));
  if (planned) result.stages[0].plan_seconds = 0;  // this time
  auto outcome = finished(std::move(model), recipe, std::move(result));
  outcome->from_levels = true;
  return outcome;
}

}  // namespace whittle::viewer
