#include "window/Scene.hh"

#include <utility>

namespace whittle::viewer {

Eigen::Vector4f edge_colour(EdgeSet set) {
  switch (set) {
    case EdgeSet::boundary:
      return {0.20f, 0.85f, 0.40f, 1};
    case EdgeSet::nonmanifold:
      return {1.00f, 0.20f, 0.60f, 1};
    case EdgeSet::feature:
      return {0.16f, 0.45f, 0.95f, 1};
    default:
      return {0.98f, 0.80f, 0.20f, 1};
  }
}

render::Look look() {
  render::Look look;
  look.background = {0.250f, 0.268f, 0.292f};
  return look;
}

double heat_top(const Session& session, const View& view) {
  if (view.heat_top) return *view.heat_top;
  return session.comparison() ? session.comparison()->heat_top : 0;
}

Sight sight(const Session& session, const Scene& scene, const View& view, const Rect& area, float pixel) {
  return {view, area.width, area.height, pixel, heat_top(session, view), scene.edition()};
}

void Scene::take_stand_in(Side& side, const StandIn* stand_in, const std::vector<float>* heat) {
  if (!stand_in) return;
  if (!side.stand_in)
    side.stand_in = std::make_shared<render::MeshBuffers>(stand_in->arrays, stand_in->triangles);
  if (heat && !side.stand_in_heat)
    side.stand_in_heat = std::make_shared<render::ValueBuffer>(values_on(*stand_in, *heat));
}

void Scene::update(const Session& session, const News& news) {
  if (news.model) {
    original_ = {};
    result_ = {};
    original_.mesh =
        std::make_shared<render::MeshBuffers>(*session.model()->arrays, session.model()->mesh().triangles);
    ++models_;
  }
  if (news.outcome) {
    result_ = {};
    original_.heat.reset();
    original_.stand_in_heat.reset();
    result_.mesh = std::make_shared<render::MeshBuffers>(*session.outcome()->arrays,
                                                         session.outcome()->mesh().triangles);
  }
  const Comparison* comparison = session.comparison();
  if (news.comparison && comparison) {
    original_.heat = std::make_shared<render::ValueBuffer>(comparison->original_heat);
    result_.heat = std::make_shared<render::ValueBuffer>(comparison->result_heat);
  }
  if (news.stand_ins || news.comparison) {
    take_stand_in(original_, session.model_stand_in(), comparison ? &comparison->original_heat : nullptr);
    take_stand_in(result_, session.outcome_stand_in(), comparison ? &comparison->result_heat : nullptr);
  }
  const bool plan_is_gone = plan_lines_ && !session.plan();
  if (news.plan || plan_is_gone) {
    plan_lines_.reset();
    plan_targets_.reset();
  }
  if (news.plan && session.plan()) {
    const PlanPicture& plan = *session.plan();
    plan_lines_ = std::make_shared<render::PointBuffer>(plan.line_ends, plan.origin);
    plan_targets_ = std::make_shared<render::PointBuffer>(plan.dots, plan.origin);
  }
  // A stand-in changes nothing: it is only ever seen where the picture changes anyway.
  if (news.model || news.outcome || news.comparison || news.plan || plan_is_gone) ++edition_;
}

}  // namespace whittle::viewer
