#include "window/Scene.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/FrameTimer.hh"
#include "render/Framebuffer.hh"

namespace whittle::viewer {
namespace {

std::unique_ptr<render::PointBuffer> line_buffer(const std::vector<std::array<std::uint32_t, 2>>& ends,
                                                 const IndexedMesh& mesh, const Eigen::Vector3d& origin) {
  std::vector<Eigen::Vector3d> points;
  points.reserve(2 * ends.size());
  for (const auto& [a, b] : ends) {
    points.push_back(mesh.points[a]);
    points.push_back(mesh.points[b]);
  }
  return std::make_unique<render::PointBuffer>(points, origin);
}

constexpr std::size_t kFrameSamples = 5;
constexpr double kLeastWire = 2.2;  // pixels: shorter edges are not drawn over a surface
constexpr int kFrameSize = 512;

/// Confines viewport and clearing; rectangles count from above, OpenGL from below.
void confine(const Pane& pane, int framebuffer_height) {
  const auto bottom = [&](const Rect& r) { return framebuffer_height - r.y - r.height; };
  glViewport(pane.picture.x, bottom(pane.picture), pane.picture.width, pane.picture.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(pane.seen.x, bottom(pane.seen), std::max(pane.seen.width, 0), std::max(pane.seen.height, 0));
}

void clear() {
  const Eigen::Vector3f c = look().background;
  glClearColor(c.x(), c.y(), c.z(), 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

}  // namespace

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

void Scene::update(const Session& session, const News& news) {
  if (news.model) {
    original_ = {};
    result_ = {};
    original_.mesh = std::make_unique<render::MeshBuffers>(session.model()->mesh());
  }
  if (news.outcome) {
    result_ = {};
    original_.heat.reset();
    result_.mesh = std::make_unique<render::MeshBuffers>(session.outcome()->mesh());
  }
  if (news.comparison && session.comparison()) {
    original_.heat = std::make_unique<render::ValueBuffer>(session.comparison()->original_heat);
    result_.heat = std::make_unique<render::ValueBuffer>(session.comparison()->result_heat);
  }
  if (news.plan || !session.plan()) {
    plan_lines_.reset();
    plan_targets_.reset();
  }
  if (news.plan && session.plan() && original_.mesh) {
    std::vector<Eigen::Vector3d> ends;
    for (const Merge& merge : session.plan()->merges) {
      ends.push_back(merge.from);
      ends.push_back(merge.to);
    }
    plan_lines_ = std::make_unique<render::PointBuffer>(ends, original_.mesh->origin());
    plan_targets_ = std::make_unique<render::PointBuffer>(session.plan()->targets, original_.mesh->origin());
  }
}

double Scene::heat_top(const Session& session, const View& view) {
  if (view.heat_top) return *view.heat_top;
  return session.comparison() ? session.comparison()->heat_top : 0;
}

bool Scene::time_frames(const Session& session) {
  const auto wanting = [](const Side& s) { return s.mesh && s.frame_ms.size() < kFrameSamples; };
  if (!session.model() || (!wanting(original_) && !wanting(result_))) return false;
  const render::Framebuffer framebuffer(kFrameSize, kFrameSize);
  const Eigen::AlignedBox3d box = session.model()->box();
  const render::Camera camera = render::frame(box, box, 1);
  for (Side* drawn : {&original_, &result_}) {
    if (!wanting(*drawn)) continue;
    framebuffer.bind();
    const auto draw_frame = [&] { renderer_.draw(*drawn->mesh, camera); };
    const std::size_t warm_up = drawn->frame_ms.empty() ? 1 : 0;
    drawn->frame_ms.push_back(render::time_frames(draw_frame, {warm_up, warm_up + 1}).wall_ms);
  }
  return true;
}

std::optional<double> Scene::frame_milliseconds(Which which) const {
  std::vector<double> samples = (which == Which::original ? original_ : result_).frame_ms;
  if (samples.size() < kFrameSamples) return std::nullopt;
  std::sort(samples.begin(), samples.end());
  return samples[samples.size() / 2];
}

void Scene::draw(const Session& session, const View& view, const Rect& area, int framebuffer_height,
                 float pixel) {
  if (area.width < 1 || area.height < 1) return;
  if (!session.model() || !original_.mesh) {
    confine({Which::original, area, area}, framebuffer_height);
    clear();
  } else {
    for (const Pane& pane : panes(view, area, result_.mesh != nullptr))
      draw_pane(session, view, pane, framebuffer_height, pixel);
  }
  glDisable(GL_SCISSOR_TEST);
}

void Scene::draw_pane(const Session& session, const View& view, const Pane& pane, int framebuffer_height,
                      float pixel) {
  if (pane.seen.width < 1 || pane.seen.height < 1) return;
  confine(pane, framebuffer_height);
  Side& drawn = side(pane.which);
  const render::Camera camera = view.orbit.camera(session.model()->box(), pane.picture.aspect());
  const auto removed = static_cast<double>(session.model()->mesh().triangles.size()) /
                       static_cast<double>(std::max<std::size_t>(drawn.mesh->triangles(), 1));
  const double edge_pixels = session.model()->scale.mean_edge / view.orbit.distance() *
                             camera.projection(1, 1) * pane.picture.height / 2 / double(pixel);
  // The fewer triangles, the longer their edges.
  draw_surface(drawn, view, camera, static_cast<float>(heat_top(session, view)),
               edge_pixels * std::sqrt(removed));

  const bool is_original = pane.which == Which::original;
  const Comparison* comparison = session.comparison();
  draw_edges(drawn, is_original ? session.model()->mesh() : session.outcome()->mesh(),
             is_original  ? &session.model()->inspection.edges
             : comparison ? &comparison->inspection.edges
                          : nullptr,
             view, camera, pixel);
  if (view.plan && is_original && plan_lines_) {
    lines_.draw_lines(*plan_lines_, camera, kPlanColour,
                      pixel * static_cast<float>(std::clamp(0.16 * edge_pixels, 1.0, 3.0)));
    lines_.draw_dots(*plan_targets_, camera, kTargetColour,
                     pixel * static_cast<float>(std::clamp(0.4 * edge_pixels, 2.0, 8.0)));
  }
}

void Scene::draw_surface(Side& drawn, const View& view, const render::Camera& camera, float heat_top,
                         double edge_pixels) {
  const bool wires = view.shading == Shading::wires || view.shading == Shading::wires_over;
  const render::MeshBuffers& mesh = *drawn.mesh;
  const bool heated = view.heat && drawn.heat;
  std::optional<render::PushBack> behind_wires;
  if (wires) behind_wires.emplace();
  if (view.shading == Shading::wires) {
    render::Look hidden = look();
    hidden.front = hidden.back = hidden.background;
    render::SurfaceStyle style;
    style.lit = false;
    clear();
    surfaces_.draw(mesh, camera, style, hidden);
  } else if (heated || view.shading == Shading::flat) {
    render::SurfaceStyle style;
    style.flat = view.shading == Shading::flat;
    if (heated) style.values = drawn.heat.get();
    style.value_at_top = std::max(heat_top, 1e-30f);
    clear();
    surfaces_.draw(mesh, camera, style, look());
  } else {
    renderer_.draw(mesh, camera, look());
  }
  behind_wires.reset();
  // Where edges lie closer than a pixel or two, wires would cover everything: they fade instead.
  const auto strength = static_cast<float>(std::clamp(edge_pixels / 14, 0.12, 0.75));
  if (view.shading == Shading::wires)
    surfaces_.draw_wires(mesh, camera, {0.80f, 0.83f, 0.87f, 1.2f * strength},
                         {0.90f, 0.32f, 0.26f, 1.2f * strength});
  if (view.shading == Shading::wires_over && edge_pixels > kLeastWire)
    surfaces_.draw_wires(mesh, camera, {0.10f, 0.11f, 0.13f, 0.7f * strength},
                         {0.20f, 0.02f, 0.02f, 0.7f * strength});
}

void Scene::draw_edges(Side& drawn, const IndexedMesh& mesh, const std::vector<Edge>* edges, const View& view,
                       const render::Camera& camera, float pixel) {
  if (!edges) return;
  for (const EdgeSet set : kEdgeSets) {
    if (!view.shows(set)) continue;
    auto& buffer = drawn.edges[static_cast<std::size_t>(set)];
    const bool outdated = set == EdgeSet::feature && drawn.feature_angle != view.feature_angle;
    if (!buffer || outdated) {
      buffer = line_buffer(select(*edges, set, view.feature_angle), mesh, drawn.mesh->origin());
      if (set == EdgeSet::feature) drawn.feature_angle = view.feature_angle;
    }
    lines_.draw_lines(*buffer, camera, edge_colour(set), 2.2f * pixel);
  }
}

}  // namespace whittle::viewer
