#include "recipe/Recipe.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include "attributes/transfer.hh"
#include "attributes/values.hh"
#include "measure/Excess.hh"
#include "recipe/Catalogue.hh"
#include "recipe/flips.hh"
#include "recipe/run_stages.hh"

namespace whittle::recipe {
namespace {

constexpr std::pair<Driver, const char*> kDrivers[] = {
    {Driver::automatic, "auto"}, {Driver::bulk, "bulk"},           {Driver::sweep, "sweep"},
    {Driver::lazy, "lazy"},      {Driver::decimater, "decimater"}, {Driver::mc, "mc"}};

/// What the first module weighs of the attributes.
ValueWeights value_weights(const Spec& module, const Scale& scale) {
  const auto weight = [&](const char* key) { return module.length(key, scale).value_or(0); };
  return {weight("normals"), weight("colours"), weight("texture")};
}

void add_values(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                const ValueWeights& weights, SurfaceExtras& extras) {
  using attributes::Kind;
  constexpr std::pair<Kind, const char*> kKinds[] = {
      {Kind::normal, "normals"}, {Kind::colour, "colours"}, {Kind::texture, "texture coordinates"}};
  for (const auto& [kind, name] : kKinds)
    if (weight_of(kind, weights) > 0 &&
        std::none_of(attributes.begin(), attributes.end(), [k = kind](const auto& a) { return a.kind == k; }))
      throw RecipeError(std::string("module 'mq': the mesh has no ") + name);
  auto values = attributes::weighted_values(mesh, attributes, weights);
  extras.values = std::move(values.values);
  extras.n_values = values.count;
}

/// For a run: flags and tolerances that were given, the seams of the attributes, and their values where the
/// first module weighs them.
SurfaceExtras extras(const IndexedMesh& mesh, const Spec& module, const Scale& scale, const Givens& givens) {
  SurfaceExtras extras;
  extras.flags = givens.flags;
  extras.tolerance = givens.tolerance;
  const ValueWeights weights = value_weights(module, scale);
  if (weights.any())
    add_values(mesh, givens.attributes ? *givens.attributes : attributes::Attributes(), weights, extras);
  if (!givens.attributes) return extras;
  const auto seams = attributes::seam_flags(mesh, *givens.attributes);
  extras.flags.resize(mesh.points.size(), 0);
  for (std::size_t v = 0; v < seams.size(); ++v) extras.flags[v] |= seams[v];
  return extras;
}

std::size_t count_held(const SurfaceExtras& extras) {
  std::size_t held = 0;
  for (std::size_t v = 0; v < std::max(extras.flags.size(), extras.tolerance.size()); ++v)
    held += (v < extras.flags.size() && extras.flags[v] != 0) ||
            (v < extras.tolerance.size() && extras.tolerance[v] == 0);
  return held;
}

Work make_work(const IndexedMesh& mesh, const Recipe& recipe, const Monitor& monitor, const Givens& givens) {
  check(recipe);
  const Scale scale = measure_scale(mesh);
  return {mesh,   group(recipe.modules),           recipe.driver,
          scale,  make_floor(recipe.target, mesh), extras(mesh, recipe.modules.front(), scale, givens),
          monitor};
}

/// Retriangulates the result, unless that breaks the bound.
void retriangulate_result(const IndexedMesh& input, const Recipe& recipe, std::optional<double> bound,
                          Result& result) {
  std::vector<IndexedMesh::Triangle> before = attributes::wedges(result.mesh, result.attributes);
  std::vector<IndexedMesh::Triangle> after = before;
  IndexedMesh mesh =
      retriangulate(result.mesh, *recipe.delaunay, result.delaunay, result.refused_faces, after);
  if (bound) {
    const double distance = measure::excess(input, mesh, *bound).max;
    if (distance > *bound && distance > *result.distance) {
      result.retriangulation_dropped = true;
      return;
    }
    result.distance = distance;
  }
  result.attributes = attributes::rewedged(result.attributes, before, after);
  result.mesh = std::move(mesh);
}

}  // namespace

Driver parse_driver(const std::string& name) {
  std::string known;
  for (const auto& [driver, driver_name] : kDrivers) {
    if (name == driver_name) return driver;
    known += (known.empty() ? "" : ", ") + std::string(driver_name);
  }
  throw RecipeError("unknown driver '" + name + "'; there are " + known);
}

std::string to_string(Driver driver) {
  for (const auto& [known, name] : kDrivers)
    if (known == driver) return name;
  return "?";
}

Scale measure_scale(const IndexedMesh& mesh) {
  Scale scale;
  double sum = 0;
  for (const auto& t : mesh.triangles)  // interior edges count twice, which leaves their mean as it is
    for (int i = 0; i < 3; ++i) sum += (mesh.points[t[(i + 1) % 3]] - mesh.points[t[i]]).norm();
  if (!mesh.triangles.empty()) scale.mean_edge = sum / (3.0 * static_cast<double>(mesh.triangles.size()));
  if (!mesh.points.empty()) {
    Eigen::Vector3d low = mesh.points[0], high = low;
    for (const auto& p : mesh.points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    scale.diagonal = (high - low).norm();
  }
  return scale;
}

void check(const Recipe& recipe) {
  const bool has_end = recipe.target.any() || recipe.max_distance;
  for (const Stage& stage : group(recipe.modules)) {
    if (value_weights(stage.module, {1, 1}).any() && stage.module.text() != recipe.modules.front().text())
      throw RecipeError("module 'mq' can weigh normals, colours and texture only as the first module");
    choose_driver(recipe.driver, stage);
    if (stage.is_planned()) make_planner(stage.module, {1, 1});
    const bool is_bounded = stage.module.has("max-distance");
    if (!has_threshold(stage.module) && !has_default_threshold(stage.module) && !has_end && !is_bounded)
      throw RecipeError(
          "module '" + stage.module.name + "' needs " +
          (threshold_key(stage.module).empty() ? "" : threshold_key(stage.module) + "=... or ") + "a target");
  }
  if (recipe.target.ratio && !(*recipe.target.ratio > 0 && *recipe.target.ratio < 1))
    throw RecipeError("the ratio must lie between 0 and 1, both ends excluded");
  if (recipe.delaunay && !(*recipe.delaunay >= 0 && *recipe.delaunay <= 180))
    throw RecipeError("the angle of the Delaunay retriangulation must lie between 0 and 180 degrees");
}

Result run(const IndexedMesh& mesh, const Recipe& recipe, const Monitor& monitor, const Givens& givens) {
  const Work work = make_work(mesh, recipe, monitor, givens);
  Result result;
  result.held = count_held(work.extras);
  std::optional<double> bound;
  Ran ran;
  if (recipe.max_distance) {
    bound = recipe.max_distance->in(work.scale);
    BoundedRan bounded = run_bounded(work, *bound);
    result.distance = bounded.distance;
    result.bound_held = bounded.held;
    result.held_by_bound = bounded.held_vertices;
    result.stopped_by_bound = bounded.stopped;
    ran = std::move(bounded);
  } else {
    ran = run_stages(work);
  }
  result.stages = std::move(ran.stages);
  result.flipped_faces = count_flips(mesh, ran.sum.mesh, ran.sum.face_origin);
  result.refused_faces = ran.sum.refused_faces;
  if (givens.attributes)
    result.attributes = attributes::transfer(*givens.attributes,
                                             {mesh, ran.sum.mesh, ran.sum.vertex_map, ran.sum.face_origin});
  result.mesh = std::move(ran.sum.mesh);
  if (recipe.delaunay) retriangulate_result(mesh, recipe, bound, result);
  result.vertex_map = std::move(ran.sum.vertex_map);
  result.target_reached = !work.floor.any() || work.floor.reached(result.mesh);
  return result;
}

CollapsePlan plan(const IndexedMesh& mesh, const Recipe& recipe, const Monitor& monitor,
                  const Givens& givens) {
  const Work work = make_work(mesh, recipe, monitor, givens);
  const ReadyStage ready = prepare(work, 0, mesh, work.extras);
  if (!ready.planner || work.floor.reached(mesh)) return {{}, {0}, {}};
  const bool at_once = ready.stage.constraints.empty();
  CollapsePlan plan =
      make_plan(mesh, work.extras, ready.job(work, 0), at_once ? ready.max_passes : 1).collapses;
  plan.collapses.resize(collapses_to_floor(plan, mesh, work.floor));
  return plan;
}

}  // namespace whittle::recipe
