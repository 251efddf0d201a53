#include "recipe/Recipe.hh"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "recipe/Catalogue.hh"
#include "recipe/passes.hh"

namespace whittle::recipe {
namespace {

/// Enough for any threshold to come to rest; an erosion that goes on longer is not what a user wants.
constexpr std::size_t kPassesToTarget = 200;

constexpr std::pair<Driver, const char*> kDrivers[] = {
    {Driver::automatic, "auto"}, {Driver::bulk, "bulk"},           {Driver::sweep, "sweep"},
    {Driver::lazy, "lazy"},      {Driver::decimater, "decimater"}, {Driver::mc, "mc"}};

std::vector<Stage> group(const std::vector<Spec>& modules) {
  std::vector<Stage> stages;
  for (const Spec& spec : modules) {
    if (find_module(spec.name).role != Role::constraint)
      stages.push_back({spec, {}});
    else if (stages.empty())
      throw RecipeError("module '" + spec.name +
                        "' only constrains; a module that decimates must stand before it");
    else
      stages.back().constraints.push_back(spec);
  }
  if (stages.empty()) throw RecipeError("no module given, and no target that the default, mq, could go to");
  return stages;
}

Driver choose_driver(Driver wanted, const Stage& stage) {
  const bool planned = find_module(stage.module.name).role == Role::planned;
  if (wanted == Driver::automatic)
    return !planned ? Driver::lazy : stage.constraints.empty() ? Driver::bulk : Driver::sweep;
  if (!planned && (wanted == Driver::bulk || wanted == Driver::sweep))
    throw RecipeError("driver '" + to_string(wanted) + "' cannot run module '" + stage.module.name +
                      "', which has no plan; use lazy, decimater or mc");
  if (wanted == Driver::bulk && !stage.constraints.empty())
    throw RecipeError("driver 'bulk' cannot run module '" + stage.constraints.front().name +
                      "', which needs an OpenMesh mesh; use sweep, lazy, decimater or mc");
  return wanted;
}

Floor make_floor(const Target& target, const IndexedMesh& mesh) {
  Floor floor;
  if (target.ratio)
    floor.faces = std::max<std::size_t>(
        1, static_cast<std::size_t>(*target.ratio * static_cast<double>(mesh.triangles.size())));
  if (target.faces) floor.faces = *target.faces;
  if (target.vertices) floor.vertices = *target.vertices;
  return floor;
}

std::string shortest(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

std::string stage_text(const Stage& stage) {
  std::string text = stage.module.text();
  for (const Spec& constraint : stage.constraints) text += " + " + constraint.text();
  return text;
}

/// Faces that point backwards, each against itself in the input.
std::size_t count_flips(const IndexedMesh& before, const IndexedMesh& after,
                        const std::vector<std::uint32_t>& origin) {
  const auto normal = [](const IndexedMesh& mesh, std::size_t f) {
    const auto& t = mesh.triangles[f];
    const Eigen::Vector3d a = mesh.points[t[0]];
    return Eigen::Vector3d((mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a));
  };
  std::size_t flips = 0;
  for (std::size_t f = 0; f < origin.size(); ++f)
    flips += normal(before, origin[f]).dot(normal(after, f)) < 0;
  return flips;
}

/// What a stage asks whether to go on.
GoOn watched(const Monitor& monitor, std::size_t stage, std::size_t stages) {
  if (!monitor) return {};
  return [=](std::size_t faces) { return monitor({stage, stages, faces}); };
}

/// How a stage is to be run.
struct Ready {
  Driver driver;
  std::optional<Planner> planner;  ///< none for stock modules
  std::size_t max_passes = 1;
};

/// Settles driver, planner and threshold of a stage; a threshold that was found is added to its module.
Ready prepare(Stage& stage, const IndexedMesh& mesh, const Recipe& recipe, const Scale& scale,
              const Floor& floor, const GoOn& go_on) {
  Ready ready{choose_driver(recipe.driver, stage), std::nullopt, 1};
  if (find_module(stage.module.name).role != Role::planned) return ready;
  ready.planner = make_planner(stage.module, scale);
  set_target(*ready.planner, floor.faces, floor.vertices);
  ready.max_passes = static_cast<std::size_t>(
      stage.module.number("passes").value_or(floor.any() ? double(kPassesToTarget) : 1.0));
  const std::string key = threshold_key(stage.module);
  if (floor.any() && !key.empty() && !has_threshold(stage.module)) {
    const double threshold =
        find_threshold(mesh, ready.driver, stage, *ready.planner, scale, floor, ready.max_passes, go_on);
    ready.planner = with_threshold(*ready.planner, threshold);
    stage.module.parameters.emplace_back(key, shortest(threshold));
  }
  return ready;
}

/// Runs one stage on `sum.mesh` and adds what came of it.
void run_stage(Stage stage, const Recipe& recipe, const Scale& scale, const Floor& floor, const GoOn& go_on,
               Passes& sum, Result& result) {
  StageResult report;
  report.faces_before = sum.sum.mesh.triangles.size();
  const Ready ready = prepare(stage, sum.sum.mesh, recipe, scale, floor, go_on);
  report.driver = ready.driver;
  Passes passes = run_passes(sum.sum.mesh, ready.driver, stage, ready.planner ? &*ready.planner : nullptr,
                             scale, floor, ready.max_passes, go_on);
  report.module = stage_text(stage);
  report.passes = passes.count;
  report.faces_after = passes.sum.mesh.triangles.size();
  report.record = passes.sum.record;
  report.collapses = passes.sum.collapses;
  report.refused_by_decimater = passes.sum.refused;
  report.plan_seconds = passes.sum.plan_seconds;
  report.execute_seconds = passes.sum.execute_seconds;
  result.stages.push_back(report);
  append(sum.sum, std::move(passes.sum));
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
  for (const Stage& stage : group(recipe.modules)) {
    choose_driver(recipe.driver, stage);
    if (find_module(stage.module.name).role == Role::planned) make_planner(stage.module, {1, 1});
    if (!has_threshold(stage.module) && !has_default_threshold(stage.module) && !recipe.target.any())
      throw RecipeError(
          "module '" + stage.module.name + "' needs " +
          (threshold_key(stage.module).empty() ? "" : threshold_key(stage.module) + "=... or ") + "a target");
  }
  if (recipe.target.ratio && !(*recipe.target.ratio > 0 && *recipe.target.ratio < 1))
    throw RecipeError("the ratio must lie between 0 and 1, both ends excluded");
  if (recipe.delaunay && !(*recipe.delaunay >= 0 && *recipe.delaunay <= 180))
    throw RecipeError("the angle of the Delaunay retriangulation must lie between 0 and 180 degrees");
}

Result run(const IndexedMesh& mesh, const Recipe& recipe, const Monitor& monitor) {
  check(recipe);
  const Scale scale = measure_scale(mesh);
  const Floor floor = make_floor(recipe.target, mesh);
  Result result;
  Passes sum = no_passes(mesh);
  const std::vector<Stage> stages = group(recipe.modules);
  for (std::size_t i = 0; i < stages.size(); ++i)
    run_stage(stages[i], recipe, scale, floor, watched(monitor, i, stages.size()), sum, result);
  result.flipped_faces = count_flips(mesh, sum.sum.mesh, sum.sum.face_origin);
  result.refused_faces = sum.sum.refused_faces;
  result.mesh = std::move(sum.sum.mesh);
  if (recipe.delaunay)
    result.mesh = retriangulate(result.mesh, *recipe.delaunay, result.delaunay, result.refused_faces);
  result.vertex_map = std::move(sum.sum.vertex_map);
  result.target_reached = !floor.any() || floor.reached(result.mesh);
  return result;
}

CollapsePlan plan(const IndexedMesh& mesh, const Recipe& recipe, const Monitor& monitor) {
  check(recipe);
  const Scale scale = measure_scale(mesh);
  const Floor floor = make_floor(recipe.target, mesh);
  std::vector<Stage> stages = group(recipe.modules);
  const GoOn go_on = watched(monitor, 0, stages.size());
  const Ready ready = prepare(stages.front(), mesh, recipe, scale, floor, go_on);
  if (!ready.planner || floor.reached(mesh)) return {{}, {0}, {}};
  const bool at_once = stages.front().constraints.empty();
  CollapsePlan plan = make_plan(mesh, *ready.planner, floor, at_once ? ready.max_passes : 1, go_on).collapses;
  plan.collapses.resize(collapses_to_floor(plan, mesh, floor));
  return plan;
}

}  // namespace whittle::recipe
