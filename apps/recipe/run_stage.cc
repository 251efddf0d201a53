#include <algorithm>
#include <utility>

#include "recipe/Stage.hh"
#include "recipe/Stopwatch.hh"
#include "recipe/openmesh.hh"
#include "whittle/plan/execute.hh"

namespace whittle::recipe {
namespace {

std::size_t max_passes(const Task& task, const Stage& stage) {
  if (!stage.is_planned()) return 1;
  if (const auto passes = stage.module.number("passes")) return static_cast<std::size_t>(*passes);
  const std::string& bound = find_module(stage.module.name).bound;
  const bool is_bounded = !bound.empty() && stage.module.has(bound);
  return task.target.any() && !is_bounded ? detail::kPassesToTarget : 1;
}

/// Executes a plan on the flat arrays.
Decimated execute_bulk(const IndexedMesh& mesh, const CollapsePlan& plan, const TargetCount& target,
                       StageResult& report) {
  Stopwatch watch;
  const std::size_t n = collapses_to_target(plan, mesh, target);
  auto executed = execute(plan, mesh, n);
  report.execute_seconds += watch.lap();
  report.collapses += n;
  return {std::move(executed.mesh), std::move(executed.vertex_map), std::move(executed.face_origin)};
}

Decimated planned_pass(const Task& task, const Stage& stage, const IndexedMesh& mesh,
                       const SurfaceExtras& extras, StageResult& report) {
  Stopwatch watch;
  const RepeatedPlan plan = plan_stage(task, stage, mesh, extras);
  report.plan_seconds += watch.lap();
  report.passes += plan.passes;
  report.record += plan.plan.record;
  return stage.driver == Driver::bulk ? execute_bulk(mesh, plan.plan, task.target, report)
                                      : execute_by_openmesh(task, stage, mesh, extras, plan.plan, report);
}

/// Runs the passes of a stage whose threshold is settled.
void run_passes(const Task& task, const Stage& stage, Decimated& now, SurfaceExtras& extras,
                StageResult& report) {
  const bool is_at_once = stage.constraints.empty() || !stage.is_planned();
  const std::size_t most = max_passes(task, stage);
  while (report.passes < most && !task.is_target_met(now.mesh)) {
    const std::size_t collapses = report.collapses;
    Decimated pass = stage.is_planned() ? planned_pass(task, stage, now.mesh, extras, report)
                                        : run_stock_modules(task, stage, now.mesh, extras, report);
    extras = carried(extras, now.mesh, pass);
    now.then(std::move(pass));
    if (is_at_once || report.collapses == collapses) break;
  }
}

/// Whether a stage with this threshold reaches the target.
bool reaches_target(const Task& task, Stage stage, double threshold, const IndexedMesh& mesh,
                    SurfaceExtras extras) {
  stage.module = with_threshold(stage.module, threshold);
  // All drivers execute the same plan, so the fastest one may search, unless constraints change what it does.
  if (stage.constraints.empty()) stage.driver = Driver::bulk;
  Decimated attempt = Decimated::unchanged(mesh);
  StageResult report;
  run_passes(task, stage, attempt, extras, report);
  return task.is_target_met(attempt.mesh);
}

/// The least threshold in a range that reaches, to 0.2 %; the last one if none does.
template <typename Reaches>
double least_threshold(const ThresholdRange& range, Reaches reaches) {
  double high = range.first;
  while (!reaches(high)) {
    if (high >= range.last) return range.last;
    high = std::min(2 * high, range.last);
  }
  double low = high == range.first ? 0 : high / 2;
  // Below a hundredth of the first, repeated passes reach the target by themselves.
  while (high - low > 0.002 * high && high > range.first / 100) {
    const double middle = (low + high) / 2;
    (reaches(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace

RepeatedPlan plan_stage(const Task& task, const Stage& stage, const IndexedMesh& mesh,
                        const SurfaceExtras& extras) {
  const auto report = [&](std::size_t faces) {
    if (!task.goes_on(stage, faces)) throw Cancelled();
  };
  report(mesh.triangles.size());
  const Planner planner = find_module(stage.module.name).make_planner(stage.module, task.scale, task.target);
  const auto enough = [&](std::size_t faces, std::size_t vertices) {
    report(faces);
    return task.target.is_met(faces, vertices);
  };
  return planner.plan(mesh, extras, stage.constraints.empty() ? max_passes(task, stage) : 1, enough);
}

std::size_t collapses_to_target(const CollapsePlan& plan, const IndexedMesh& mesh,
                                const TargetCount& target) {
  std::size_t faces = mesh.triangles.size(), vertices = mesh.points.size(), n = 0;
  for (const Collapse& collapse : plan.collapses) {
    if (target.is_met(faces, vertices)) break;
    faces -= collapse.faces;
    --vertices;
    ++n;
  }
  return n;
}

ThresholdRange threshold_range(const Module& module, const Scale& scale) {
  const Key& key = *module.find(module.threshold);
  if (key.measure == Measure::degrees) return {1, key.max};
  return {scale.mean_edge / 8, 2 * scale.diagonal};
}

void find_threshold(const Task& task, Stage& stage, const IndexedMesh& mesh, const SurfaceExtras& extras) {
  const Module& module = find_module(stage.module.name);
  if (!stage.is_planned() || !task.target.any() || module.threshold.empty() || has_threshold(stage.module))
    return;
  const double threshold = least_threshold(threshold_range(module, task.scale), [&](double tried) {
    return reaches_target(task, stage, tried, mesh, extras);
  });
  stage.module = with_threshold(stage.module, threshold);
}

StageResult run_stage(const Task& task, Stage stage, Decimated& now, SurfaceExtras& extras) {
  find_threshold(task, stage, now.mesh, extras);
  StageResult report;
  report.module = stage.text();
  report.driver = stage.driver;
  report.faces_before = now.mesh.triangles.size();
  run_passes(task, stage, now, extras, report);
  report.faces_after = now.mesh.triangles.size();
  return report;
}

Result run_stages(const Task& task) {
  Result result;
  static_cast<Decimated&>(result) = Decimated::unchanged(task.mesh);
  SurfaceExtras extras = task.extras;
  for (const Stage& stage : task.stages) result.stages.push_back(run_stage(task, stage, result, extras));
  return result;
}

}  // namespace whittle::recipe
