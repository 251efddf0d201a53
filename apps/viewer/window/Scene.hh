/// \file
/// The meshes as they are drawn: what lies in the graphics memory, and how a view shows it.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "model/Session.hh"
#include "model/View.hh"
#include "model/panes.hh"
#include "render/LinePainter.hh"
#include "render/SurfacePainter.hh"

namespace whittle::viewer {

/// The colours of what is drawn over meshes.
Eigen::Vector4f edge_colour(EdgeSet set);
inline const Eigen::Vector4f kPlanColour{1.00f, 0.62f, 0.16f, 0.95f};
inline const Eigen::Vector4f kTargetColour{0.16f, 0.30f, 0.62f, 1.0f};

/// What surrounds the meshes, and their sides.
render::Look look();

class Scene {
 public:
  /// Takes what is new in the session into the graphics memory.
  void update(const Session& session, const News& news);

  /// Draws into the bound framebuffer of this height, in pixels. \param pixel  width of a thin line.
  void draw(const Session& session, const View& view, const Rect& area, int framebuffer_height, float pixel);

  /// Times one frame of each mesh, if they still need it: to be called when there is nothing else to do.
  /// \return whether more of that is to be done.
  bool time_frames(const Session& session);
  /// How long a frame takes: the Renderer at 512 by 512 pixels, as the benchmark draws it. The median of a
  /// few; none before.
  std::optional<double> frame_milliseconds(Which which) const;

  /// The distance that gets the last heat colour, in model units.
  static double heat_top(const Session& session, const View& view);

 private:
  /// One mesh with all that can be drawn on it.
  struct Side {
    std::unique_ptr<render::MeshBuffers> mesh;
    std::unique_ptr<render::ValueBuffer> heat;
    std::array<std::unique_ptr<render::PointBuffer>, 4> edges;  ///< by EdgeSet
    double feature_angle = -1;                                  ///< of the feature edges in `edges`
    std::vector<double> frame_ms;                               ///< samples so far
  };

  Side& side(Which which) { return which == Which::original ? original_ : result_; }
  void draw_pane(const Session& session, const View& view, const Pane& pane, int framebuffer_height,
                 float pixel);
  /// \param edge_pixels  how long a mean edge in the middle of the picture is.
  void draw_surface(Side& side, const View& view, const render::Camera& camera, float heat_top,
                    double edge_pixels);
  void draw_edges(Side& side, const IndexedMesh& mesh, const std::vector<Edge>* edges, const View& view,
                  const render::Camera& camera, float pixel);

  render::Renderer renderer_;
  render::SurfacePainter surfaces_;
  render::LinePainter lines_;
  Side original_, result_;
  std::unique_ptr<render::PointBuffer> plan_lines_, plan_targets_;
};

}  // namespace whittle::viewer
