/// \file
/// How a view shows the meshes.
#include <algorithm>
#include <cmath>
#include <optional>

#include "window/Scene.hh"

namespace whittle::viewer {
namespace {

constexpr double kLeastWire = 2.2;  // pixels: shorter edges are not drawn over a surface
constexpr std::size_t kFewLines = 20000;

/// Confines viewport and clearing; rectangles count from above, OpenGL from below.
void confine(const Pane& pane, int picture_height) {
  const auto bottom = [&](const Rect& r) { return picture_height - r.y - r.height; };
  glViewport(pane.picture.x, bottom(pane.picture), pane.picture.width, pane.picture.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(pane.seen.x, bottom(pane.seen), std::max(pane.seen.width, 0), std::max(pane.seen.height, 0));
}

Stroke clearing(const Pane& pane, int picture_height) {
  return {1, [=](std::size_t, std::size_t) {
            confine(pane, picture_height);
            render::clear(look());
          }};
}

}  // namespace

std::vector<Stroke> Scene::strokes(const Session& session, const Sight& sight, Detail detail) {
  std::vector<Stroke> all;
  const Rect area{0, 0, sight.width, sight.height};
  const Model* model = session.model();
  if (!model || !original_.mesh) {
    all.push_back(clearing({Which::original, area, area}, sight.height));
    return all;
  }
  const std::size_t most = detail == Detail::full ? ~std::size_t{0} : kFewLines;
  for (const Pane& pane : panes(sight.view, area, result_.mesh != nullptr)) {
    if (pane.seen.width < 1 || pane.seen.height < 1) continue;
    Place place{pane, sight.height, sight.view.orbit.camera(model->box(), pane.picture.aspect()), 0};
    place.edge_pixels = model->scale.mean_edge / sight.view.orbit.distance() * place.camera.projection(1, 1) *
                        pane.picture.height / 2 / double(sight.pixel);
    all.push_back(clearing(pane, sight.height));
    add_surface(all, side(pane.which), place, sight, detail);
    const bool is_original = pane.which == Which::original;
    const Comparison* comparison = session.comparison();
    const Inspection* inspection = is_original  ? &model->inspection
                                   : comparison ? &comparison->inspection
                                                : nullptr;
    if (inspection) add_edges(all, side(pane.which), inspection->edges, place, sight, most);
    if (sight.view.plan && is_original && plan_lines_) add_plan(all, place, sight.pixel, most);
  }
  return all;
}

void Scene::add_surface(std::vector<Stroke>& strokes, const Side& side, const Place& place,
                        const Sight& sight, Detail detail) const {
  const View& view = sight.view;
  const bool sketched = detail == Detail::sketch && side.stand_in;
  const Mesh& mesh = sketched ? side.stand_in : side.mesh;
  const Values heat = !view.heat ? nullptr : sketched ? side.stand_in_heat : side.heat;
  const bool pushed = view.shading == Shading::wires || view.shading == Shading::wires_over;

  render::SurfaceStyle style;
  style.flat = view.shading == Shading::flat;
  style.lit = view.shading != Shading::wires;
  style.value_at_top = std::max(static_cast<float>(sight.heat_top), 1e-30f);
  render::Look colours = look();
  if (!style.lit) colours.front = colours.back = colours.background;
  const auto paint = [=](std::size_t first, std::size_t count) {
    confine(place.pane, place.height);
    std::optional<render::PushBack> behind_wires;
    if (pushed) behind_wires.emplace();
    render::SurfaceStyle heated = style;
    if (style.lit) heated.values = heat.get();
    if (style.lit && !style.flat && !heated.values)
      renderer_.draw_part(*mesh, place.camera, colours, {first, count});
    else
      surfaces_.draw(*mesh, place.camera, heated, colours, {first, count});
  };
  strokes.push_back({mesh->triangles(), paint});

  // The fewer triangles, the longer their edges. Where they lie closer than a pixel or two, wires would cover
  // everything: they fade instead.
  const double fewer = static_cast<double>(original_.mesh->triangles()) /
                       static_cast<double>(std::max<std::size_t>(mesh->triangles(), 1));
  const double edge_pixels = place.edge_pixels * std::sqrt(fewer);
  const auto strength = static_cast<float>(std::clamp(edge_pixels / 14, 0.12, 0.75));
  if (view.shading == Shading::wires) add_wires(strokes, mesh, place, 1.2f * strength, false);
  if (view.shading == Shading::wires_over && detail == Detail::full && edge_pixels > kLeastWire)
    add_wires(strokes, mesh, place, 0.7f * strength, true);
}

void Scene::add_wires(std::vector<Stroke>& strokes, const Mesh& mesh, const Place& place, float opacity,
                      bool over) const {
  const Eigen::Vector4f front =
      over ? Eigen::Vector4f(0.10f, 0.11f, 0.13f, opacity) : Eigen::Vector4f(0.80f, 0.83f, 0.87f, opacity);
  const Eigen::Vector4f back =
      over ? Eigen::Vector4f(0.20f, 0.02f, 0.02f, opacity) : Eigen::Vector4f(0.90f, 0.32f, 0.26f, opacity);
  strokes.push_back({mesh->triangles(), [=](std::size_t first, std::size_t count) {
                       confine(place.pane, place.height);
                       surfaces_.draw_wires(*mesh, place.camera, front, back, {first, count});
                     }});
}

void Scene::add_edges(std::vector<Stroke>& strokes, Side& side, const EdgeSets& edges, const Place& place,
                      const Sight& sight, std::size_t most) {
  for (const EdgeSet set : kEdgeSets) {
    const std::size_t count = sight.view.shows(set) ? edges.count(set, sight.view.feature_angle) : 0;
    if (count == 0 || count > most) continue;
    Points& buffer = side.edges[static_cast<std::size_t>(set)];
    if (!buffer) buffer = std::make_shared<render::PointBuffer>(*side.mesh, edges.of(set));
    const auto paint = [=, lines = buffer, pixel = sight.pixel](std::size_t first, std::size_t n) {
      confine(place.pane, place.height);
      lines_.draw_lines(*lines, place.camera, edge_colour(set), 2.2f * pixel, {first, n});
    };
    strokes.push_back({count, paint});
  }
}

void Scene::add_plan(std::vector<Stroke>& strokes, const Place& place, float pixel, std::size_t most) const {
  const auto width = static_cast<float>(std::clamp(0.16 * place.edge_pixels, 1.0, 3.0));
  const auto size = static_cast<float>(std::clamp(0.4 * place.edge_pixels, 2.0, 8.0));
  if (plan_lines_->size() / 2 > most) return;
  strokes.push_back({plan_lines_->size() / 2, [=, lines = plan_lines_](std::size_t first, std::size_t count) {
                       confine(place.pane, place.height);
                       lines_.draw_lines(*lines, place.camera, kPlanColour, pixel * width, {first, count});
                     }});
  strokes.push_back({plan_targets_->size(), [=, dots = plan_targets_](std::size_t first, std::size_t count) {
                       confine(place.pane, place.height);
                       lines_.draw_dots(*dots, place.camera, kTargetColour, pixel * size, {first, count});
                     }});
}

}  // namespace whittle::viewer
