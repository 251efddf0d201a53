#include "recipe/Recipe.hh"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "attributes/transfer.hh"
#include "attributes/values.hh"
#include "measure/Excess.hh"
#include "measure/sides.hh"
#include "recipe/Catalogue.hh"
#include "recipe/Stage.hh"
#include "recipe/Stopwatch.hh"
#include "recipe/flips.hh"
#include "recipe/openmesh.hh"
#include "recipe/pieces.hh"
#include "whittle/surface/charts.hh"
#include "whittle/surface/errors.hh"

namespace whittle::recipe {
namespace {

/// What a module weighs of the attributes.
/// \param defaults  what it weighs where its specification does not say
ValueWeights value_weights(const Spec& module, const Scale& scale, const ValueWeights& defaults = {}) {
  const auto weight = [&](const char* key, double otherwise) {
    return find_module(module.name).find(key) ? module.length(key, scale).value_or(otherwise) : 0;
  };
  return {weight("normals", defaults.normals), weight("colours", defaults.colours),
          weight("texture", defaults.texture)};
}

void add_values(const IndexedMesh& mesh, const attributes::Attributes& attributes, const Spec& module,
                const ValueWeights& weights, SurfaceExtras& extras) {
  using attributes::Kind;
  constexpr std::pair<Kind, const char*> kKinds[] = {
      {Kind::normal, "normals"}, {Kind::colour, "colours"}, {Kind::texture, "texture coordinates"}};
  for (const auto& [kind, name] : kKinds)
    if (weight_of(kind, weights) > 0 &&
        std::none_of(attributes.begin(), attributes.end(), [k = kind](const auto& a) { return a.kind == k; }))
      throw RecipeError("module '" + module.name + "': the mesh has no " + name);
  auto values = attributes::weighted_values(mesh, attributes, weights);
  extras.values = std::move(values.values);
  extras.n_values = values.count;
}

/// For a run: flags and tolerances that were given, the seams of the attributes, and their values where the
/// first module weighs them.
SurfaceExtras extras(const IndexedMesh& mesh, const std::vector<Spec>& modules, const Scale& scale,
                     const Givens& givens) {
  SurfaceExtras extras;
  extras.flags = givens.flags;
  extras.tolerance = givens.tolerance;
  if (!modules.empty()) {
    const ValueWeights weights = value_weights(
        modules.front(), scale,
        givens.attributes ? attributes::default_weights(mesh, *givens.attributes) : ValueWeights());
    if (weights.any())
      add_values(mesh, givens.attributes ? *givens.attributes : attributes::Attributes(), modules.front(),
                 weights, extras);
  }
  if (!givens.attributes && givens.areas.empty()) return extras;
  extras.wedges = wedges_of(givens);
  flag_seams(mesh, extras);
  return extras;
}

struct Held {
  std::size_t all = 0, on_seams = 0;  // the latter for no other reason
};

Held count_held(const Task& task) {
  const SurfaceExtras& extras = task.extras;
  const unsigned holds = flags_that_hold(task.stages);
  Held held;
  for (std::size_t v = 0; v < std::max(extras.flags.size(), extras.tolerance.size()); ++v) {
    const unsigned flags = v < extras.flags.size() ? extras.flags[v] & holds : 0u;
    const bool is_rigid = v < extras.tolerance.size() && extras.tolerance[v] == 0;
    held.all += flags != 0 || is_rigid;
    held.on_seams += flags == kSeam && !is_rigid;
  }
  return held;
}

void count_charts(const Task& task, Result& result) {
  const std::vector<std::uint8_t>& flags = task.extras.flags;
  const bool has_seams =
      !task.extras.wedges.empty() &&
      std::any_of(flags.begin(), flags.end(), [](std::uint8_t flag) { return (flag & kSeam) != 0; });
  if (!has_seams) return;
  const Charts before = charts(task.mesh.triangles, task.extras.wedges);
  result.charts = before.count;
  result.charts_gone = count_vanished(before, result.face_origin);
}

TargetCount count_of(const Target& target, const IndexedMesh& mesh) {
  TargetCount count;
  if (target.ratio)
    count.faces = std::max<std::size_t>(
        1, static_cast<std::size_t>(*target.ratio * static_cast<double>(mesh.triangles.size())));
  if (target.faces) count.faces = *target.faces;
  if (target.vertices) count.vertices = *target.vertices;
  return count;
}

void check_triangles(const IndexedMesh& mesh) {
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t)
      if (v >= mesh.points.size())
        throw InvalidMesh("a triangle names vertex " + std::to_string(v) + " of " +
                          std::to_string(mesh.points.size()));
}

/// Each edge counts once, whatever number of faces it has.
double mean_edge(const IndexedMesh& mesh) {
  double sum = 0;
  std::size_t edges = 0;
  const auto sides = measure::sides_by_edge(mesh.triangles, mesh.points.size(), measure::Faces::proper);
  measure::for_each_edge(sides, [&](const measure::Side* side, const measure::Side*) {
    sum += (mesh.points[side->low] - mesh.points[side->high]).norm();
    ++edges;
  });
  return edges > 0 ? sum / static_cast<double>(edges) : 0;
}

double diagonal(const IndexedMesh& mesh) {
  if (mesh.points.empty()) return 0;
  Eigen::Vector3d low = mesh.points[0], high = low;
  for (const auto& p : mesh.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

Task make_task(const IndexedMesh& mesh, const Recipe& recipe, const Monitor& monitor, const Givens& givens) {
  check(recipe);
  check_triangles(mesh);
  Scale scale{LateLength([&mesh] { return mean_edge(mesh); }), diagonal(mesh)};  // the task has the mesh, too
  if (givens.diagonal > 0) scale.diagonal = givens.diagonal;
  return {mesh,           stages_of(recipe),
          scale,          count_of(recipe.target, mesh),
          recipe.samples, extras(mesh, recipe.modules, scale, givens),
          monitor};
}

/// Whether a mesh may take the result's place: there is no bound, or it keeps the bound, or it lies no farther from the
/// input than the result does. Takes down how far it lies.
bool keeps_bound(const IndexedMesh& input, const IndexedMesh& mesh, std::optional<double> bound,
                 Result& result) {
  if (!bound) return true;
  const double distance = measure::excess(input, mesh, *bound).max;
  if (distance > *bound && distance > *result.distance) return false;
  result.distance = distance;
  return true;
}

/// Refits the result, unless that breaks the bound.
void refit_result(const Task& task, std::optional<double> bound, Result& result) {
  RefitOptions options;
  options.flags = detail::refit_flags(task.mesh, task.extras);
  Stopwatch watch;
  IndexedMesh mesh = result.mesh;
  const RefitReport report = refit(task.mesh, mesh, result.vertex_map, result.face_origin, options);
  result.refit_seconds = watch.lap();
  result.refit_dropped = !keeps_bound(task.mesh, mesh, bound, result);
  if (result.refit_dropped) return;
  result.refit = report;
  result.mesh = std::move(mesh);
}

/// The parts of faces after flips: no edge between parts is flipped, as it is on a seam.
std::vector<std::uint32_t> parts_by_wedges(const std::vector<std::uint32_t>& parts,
                                           const std::vector<IndexedMesh::Triangle>& before,
                                           const std::vector<IndexedMesh::Triangle>& after) {
  std::vector<std::uint32_t> of_wedge, out;
  for (std::size_t f = 0; f < parts.size(); ++f)
    for (const std::uint32_t wedge : before[f]) {
      if (wedge >= of_wedge.size()) of_wedge.resize(wedge + std::size_t{1});
      of_wedge[wedge] = parts[f];
    }
  for (std::size_t f = 0; !parts.empty() && f < after.size(); ++f) out.push_back(of_wedge[after[f][0]]);
  return out;
}

/// Retriangulates the result, unless that breaks the bound.
void retriangulate_result(const IndexedMesh& input, const Recipe& recipe, std::optional<double> bound,
                          Result& result) {
  const std::vector<IndexedMesh::Triangle> before =
      attributes::wedges(result.mesh, result.attributes, result.parts);
  std::vector<IndexedMesh::Triangle> after = before;
  IndexedMesh mesh =
      retriangulate(result.mesh, *recipe.delaunay, result.delaunay, result.refused_faces, after);
  result.retriangulation_dropped = !keeps_bound(input, mesh, bound, result);
  if (result.retriangulation_dropped) return;
  result.attributes = attributes::rewedged(result.attributes, before, after);
  result.parts = parts_by_wedges(result.parts, before, after);
  result.mesh = std::move(mesh);
  result.face_origin.clear();
}

/// \throw RecipeError  a stage that cannot run.
void check_stage(const Stage& stage, bool has_end) {
  const Module& module = find_module(stage.module.name);
  if (stage.index > 0 && value_weights(stage.module, {1, 1}).any())
    throw RecipeError("module '" + module.name +
                      "' can weigh normals, colours and texture only as the first module");
  if (stage.is_planned()) module.make_planner(stage.module, {1, 1}, {});
  const bool is_bounded = !module.bound.empty() && stage.module.has(module.bound);
  if (has_end || is_bounded || module.ends_by_itself || has_threshold(stage.module)) return;
  throw RecipeError("module '" + module.name + "' needs " +
                    (module.threshold.empty() ? "" : module.threshold + "=... or ") + "a target");
}

}  // namespace

const std::vector<DriverInfo>& drivers() {
  static const std::vector<DriverInfo> all = {{Driver::automatic, "auto", "the fastest that can"},
                                              {Driver::bulk, "bulk", "the plan on flat arrays"},
                                              {Driver::sweep, "sweep", "SweepDecimaterT"},
                                              {Driver::lazy, "lazy", "LazyDecimaterT"},
                                              {Driver::decimater, "decimater", "OpenMesh's DecimaterT"},
                                              {Driver::mc, "mc", "OpenMesh's McDecimaterT"}};
  return all;
}

Driver parse_driver(const std::string& name) {
  std::string known;
  for (const DriverInfo& info : drivers()) {
    if (name == info.name) return info.driver;
    known += (known.empty() ? "" : ", ") + std::string(info.name);
  }
  throw RecipeError("unknown driver '" + name + "'; there are " + known);
}

std::string to_string(Driver driver) {
  const auto& all = drivers();
  return std::find_if(all.begin(), all.end(), [&](const DriverInfo& info) { return info.driver == driver; })
      ->name;
}

std::string PieceRule::text() const {
  return what == What::keep ? "keep" : what == What::by_error ? "by-error" : length.text();
}

PieceRule parse_pieces(const std::string& text) {
  if (text == "keep") return {};
  if (text == "by-error") return {PieceRule::What::by_error, {}};
  if (text.empty() || std::isalpha(static_cast<unsigned char>(text[0])))
    throw RecipeError("'" + text + "' is no rule for pieces; there are keep, by-error and a length");
  const PieceRule rule{PieceRule::What::below, parse_length(text)};
  if (rule.length.amount <= 0) throw RecipeError("the length must be above 0");
  return rule;
}

Scale measure_scale(const IndexedMesh& mesh) {
  check_triangles(mesh);
  return {mean_edge(mesh), diagonal(mesh)};
}

void check(const Recipe& recipe) {
  for (const Stage& stage : stages_of(recipe)) check_stage(stage, recipe.target.any() || recipe.max_distance);
  if (recipe.target.ratio && !(*recipe.target.ratio > 0 && *recipe.target.ratio <= 1))
    throw RecipeError("the ratio must be above 0 and at most 1");
  if (recipe.pieces.what == PieceRule::What::by_error && !recipe.target.any())
    throw RecipeError(
        "pieces vanish by error on the way to a target only; give one, or a length for the pieces");
  if (recipe.delaunay && !(*recipe.delaunay >= 0 && *recipe.delaunay <= 180))
    throw RecipeError("the angle of the Delaunay retriangulation must lie between 0 and 180 degrees");
  for (const Spec& spec : recipe.modules)
    if (const std::string& bound = find_module(spec.name).bound;
        recipe.refit.value_or(false) && !bound.empty() && spec.has(bound))
      throw RecipeError("a refit does not keep the bound '" + bound + "' of module '" + spec.name +
                        "'; --max-distance bounds the whole run, and the refit with it");
}

double Result::seconds() const {
  double sum = refit_seconds;
  for (const StageResult& stage : stages) sum += stage.plan_seconds + stage.execute_seconds;
  return sum;
}

bool wants_refit(const Recipe& recipe) {
  if (recipe.refit) return *recipe.refit;
  const std::vector<Stage> stages = stages_of(recipe);
  if (stages.empty()) return false;
  const Spec& last = stages.back().module;
  const Module& module = find_module(last.name);
  return module.refits && !recipe.max_distance && (module.bound.empty() || !last.has(module.bound));
}

std::vector<std::uint8_t> held_in_refit(const IndexedMesh& mesh, const Givens& givens) {
  SurfaceExtras held;
  held.flags = givens.flags;
  held.tolerance = givens.tolerance;
  held.wedges = wedges_of(givens);
  if (givens.attributes) held.n_values = attributes::default_weights(mesh, *givens.attributes).any() ? 1 : 0;
  return detail::refit_flags(mesh, held);
}

std::vector<IndexedMesh::Triangle> wedges_of(const Givens& givens) {
  const attributes::Attributes none;
  return attributes::seam_wedges(givens.attributes ? *givens.attributes : none, givens.seams, givens.areas);
}

std::vector<std::uint32_t> parts_of(const Givens& givens, const Decimated& result) {
  std::vector<std::uint32_t> parts;
  if (!givens.parts || givens.parts->empty()) return parts;
  parts.reserve(result.face_origin.size());
  for (const std::uint32_t face : result.face_origin) parts.push_back((*givens.parts)[face]);
  return parts;
}

Result run(const IndexedMesh& mesh, const Recipe& recipe, const Monitor& monitor, const Givens& givens) {
  Task task = make_task(mesh, recipe, monitor, givens);
  const TargetCount target = task.target;
  const Held held = count_held(task);
  const detail::PieceChoice pieces = choose_pieces(recipe, task);
  std::optional<double> bound;
  if (recipe.max_distance) bound = recipe.max_distance->in(task.scale);
  Result result = bound ? run_bounded(task, *bound) : run_stages(task);
  result.held = held.all;
  result.held_on_seams = held.on_seams;
  result.attainable = pieces.attainable;
  // What has lost no face is the input as it is.
  if (wants_refit(recipe) && result.mesh.triangles.size() < mesh.triangles.size())
    refit_result(task, bound, result);
  count_charts(task, result);
  result.flipped_faces = count_flips(mesh, result.mesh, result.face_origin);
  if (givens.attributes)
    result.attributes = attributes::transfer(
        *givens.attributes, {mesh, result.mesh, result.vertex_map, result.face_origin}, givens.seams);
  remove_pieces(mesh, pieces, result);
  result.parts = parts_of(givens, result);
  if (recipe.delaunay) retriangulate_result(mesh, recipe, bound, result);
  result.target_reached =
      !target.any() || target.is_met(result.mesh.triangles.size(), result.mesh.points.size());
  return result;
}

CollapsePlan plan(const IndexedMesh& mesh, const Recipe& recipe, const Monitor& monitor,
                  const Givens& givens) {
  Task task = make_task(mesh, recipe, monitor, givens);
  choose_pieces(recipe, task);
  if (task.stages.empty()) return {{}, {0}, {}};
  Stage stage = task.stages.front();
  if (!stage.is_planned() || task.is_target_met(mesh)) return {{}, {0}, {}};
  find_threshold(task, stage, mesh, task.extras);
  CollapsePlan plan = plan_stage(task, stage, mesh, task.extras).plan;
  plan.collapses.resize(collapses_to_target(plan, mesh, task.target));
  return plan;
}

}  // namespace whittle::recipe
