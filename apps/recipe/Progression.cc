#include "recipe/Progression.hh"

#include "attributes/transfer.hh"
#include "recipe/Catalogue.hh"
#include "recipe/Stopwatch.hh"
#include "recipe/flips.hh"
#include "whittle/plan/execute.hh"

namespace whittle::recipe {
namespace {

Recipe down_to_nothing() {
  Recipe recipe;
  recipe.modules = {default_module()};
  recipe.target.faces = 1;
  recipe.force = true;
  return recipe;
}

}  // namespace

Progression::Progression(const IndexedMesh& mesh, const Givens& givens, const Monitor& monitor)
    : mesh_(mesh), givens_(givens), least_(mesh.triangles.size()) {
  Stopwatch watch;
  plan_ = plan(mesh, down_to_nothing(), monitor, givens);
  plan_seconds_ = watch.lap();
  pieces_ = pieces_of(mesh);
  held_in_refit_ = held_in_refit(mesh, givens);
  seam_record_ = detail::SeamRecord(mesh, wedges_of(givens_));
  for (const Collapse& collapse : plan_.collapses) least_ -= collapse.faces;
}

Result Progression::at(std::size_t faces, bool with_refit) const {
  Stopwatch watch;
  Result result;
  result.attainable = attainable(mesh_, pieces_, {}, givens_.flags, kLocked | kFeature, {faces, 0});
  std::size_t left = mesh_.triangles.size(), n = 0;
  while (n < plan_.collapses.size() && left > result.attainable.target.faces)
    left -= plan_.collapses[n++].faces;
  auto executed = execute(plan_, mesh_, n);
  if (!seam_record_.empty()) {
    result.charts = seam_record_.charts.count;
    result.charts_gone = count_vanished(seam_record_.charts, executed.face_origin);
  }
  if (with_refit) {
    RefitOptions options;
    options.flags = held_in_refit_;
    result.refit = refit(mesh_, executed, options);
  }
  result.flipped_faces = count_flips(mesh_, executed.mesh, executed.face_origin);
  if (givens_.attributes)
    result.attributes = attributes::transfer(
        *givens_.attributes, {mesh_, executed.mesh, executed.vertex_map, executed.face_origin},
        givens_.seams);
  StageResult stage;
  stage.module = default_module().text();
  stage.driver = Driver::bulk;
  stage.passes = 1;
  stage.faces_before = mesh_.triangles.size();
  stage.faces_after = executed.mesh.triangles.size();
  stage.collapses = n;
  stage.plan_seconds = plan_seconds_;
  stage.execute_seconds = watch.lap();
  result.stages.push_back(stage);
  result.mesh = std::move(executed.mesh);
  result.vertex_map = std::move(executed.vertex_map);
  result.face_origin = std::move(executed.face_origin);
  result.parts = parts_of(givens_, result);
  result.target_reached = result.mesh.triangles.size() <= faces;
  return result;
}

}  // namespace whittle::recipe
