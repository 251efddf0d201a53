#include "recipe/run_stages.hh"

#include <utility>

namespace whittle::recipe {
namespace {

/// Enough for any threshold to come to rest; an erosion that goes on longer is not what a user wants.
constexpr std::size_t kPassesToTarget = 200;

/// What a stage asks whether to go on.
GoOn watched(const Work& work, std::size_t stage) {
  if (!work.monitor) return {};
  return [&monitor = work.monitor, stage, stages = work.stages.size()](std::size_t faces) {
    return monitor({stage, stages, faces});
  };
}

StageResult describe(const ReadyStage& ready, std::size_t faces_before, const Passes& passes) {
  StageResult report;
  report.module = ready.stage.text();
  report.driver = ready.driver;
  report.passes = passes.count;
  report.faces_before = faces_before;
  report.faces_after = passes.sum.mesh.triangles.size();
  report.record = passes.sum.record;
  report.collapses = passes.sum.collapses;
  report.refused_by_decimater = passes.sum.refused;
  report.plan_seconds = passes.sum.plan_seconds;
  report.execute_seconds = passes.sum.execute_seconds;
  return report;
}

}  // namespace

Job ReadyStage::job(const Work& work, std::size_t index) const {
  return {stage,      driver,     planner ? &*planner : nullptr, work.scale,
          work.floor, max_passes, watched(work, index)};
}

ReadyStage prepare(const Work& work, std::size_t index, const IndexedMesh& mesh,
                   const SurfaceExtras& extras) {
  ReadyStage ready{work.stages[index], choose_driver(work.driver, work.stages[index]), std::nullopt, 1};
  Spec& module = ready.stage.module;
  if (!ready.stage.is_planned()) return ready;
  ready.planner = make_planner(module, work.scale);
  set_target(*ready.planner, work.floor.faces, work.floor.vertices);
  const bool is_once = !work.floor.any() || module.has("max-distance");
  ready.max_passes =
      static_cast<std::size_t>(module.number("passes").value_or(is_once ? 1.0 : double(kPassesToTarget)));
  if (work.floor.any() && !threshold_key(module).empty() && !has_threshold(module)) {
    const double threshold = find_threshold(mesh, extras, ready.job(work, index));
    ready.planner = with_threshold(*ready.planner, threshold);
    module = with_threshold(module, threshold);
  }
  return ready;
}

Ran run_stages(const Work& work) {
  Ran ran{no_passes(work.mesh).sum, {}};
  SurfaceExtras extras = work.extras;
  for (std::size_t i = 0; i < work.stages.size(); ++i) {
    const ReadyStage ready = prepare(work, i, ran.sum.mesh, extras);
    Passes passes = run_passes(ran.sum.mesh, extras, ready.job(work, i));
    ran.stages.push_back(describe(ready, ran.sum.mesh.triangles.size(), passes));
    extras = carried(extras, passes.sum);
    append(ran.sum, std::move(passes.sum));
  }
  return ran;
}

}  // namespace whittle::recipe
