/// \file
/// The meshes as they are drawn: what lies in the graphics memory, and how a view shows it.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "model/Painting.hh"
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

/// A picture of the views: what it shows, and how large.
struct Sight {
  View view;
  int width = 0, height = 0;
  float pixel = 1;          ///< width of a thin line
  double heat_top = 0;      ///< the distance that gets the last heat colour, in model units
  std::size_t edition = 0;  ///< of the scene

  bool empty() const { return width < 1 || height < 1; }
  bool operator==(const Sight& other) const {
    return view == other.view && width == other.width && height == other.height && pixel == other.pixel &&
           heat_top == other.heat_top && edition == other.edition;
  }
};

/// A picture as it should be, or one that is drawn soon: stand-ins of large meshes, no wires over surfaces,
/// and of the lines only those that are few.
enum class Detail { full, sketch };

class Scene {
 public:
  /// Takes what is new in the session into the graphics memory.
  void update(const Session& session, const News& news);

  std::size_t edition() const { return edition_; }  ///< another number whenever the meshes look different
  std::size_t models() const { return models_; }    ///< how many have been opened

  /// What must be drawn for a picture, into a framebuffer of its size. The strokes hold what they draw: they
  /// stay good when the scene changes. They need the scene itself.
  std::vector<Stroke> strokes(const Session& session, const Sight& sight, Detail detail);

  /// Null before there is one.
  std::shared_ptr<const render::MeshBuffers> mesh(Which which) const { return side(which).mesh; }
  const render::Renderer& renderer() const { return renderer_; }

 private:
  using Mesh = std::shared_ptr<const render::MeshBuffers>;
  using Values = std::shared_ptr<const render::ValueBuffer>;
  using Points = std::shared_ptr<const render::PointBuffer>;

  /// One mesh with all that can be drawn on it.
  struct Side {
    Mesh mesh, stand_in;
    Values heat, stand_in_heat;
    std::array<Points, 4> edges;  ///< by EdgeSet
  };

  /// What the strokes of one pane have in common.
  struct Place {
    Pane pane;
    int height;  ///< of the whole picture, pixels
    render::Camera camera;
    double edge_pixels;  ///< how long a mean edge of the original is in the middle of the picture
  };

  const Side& side(Which which) const { return which == Which::original ? original_ : result_; }
  Side& side(Which which) { return which == Which::original ? original_ : result_; }
  static void take_stand_in(Side& side, const StandIn* stand_in, const std::vector<float>* heat);

  void add_surface(std::vector<Stroke>& strokes, const Side& side, const Place& place, const Sight& sight,
                   Detail detail) const;
  /// \param over  a surface, not alone.
  void add_wires(std::vector<Stroke>& strokes, const Mesh& mesh, const Place& place, float opacity,
                 bool over) const;
  void add_edges(std::vector<Stroke>& strokes, Side& side, const EdgeSets& edges, const Place& place,
                 const Sight& sight, std::size_t most);
  void add_plan(std::vector<Stroke>& strokes, const Place& place, float pixel, std::size_t most) const;

  render::Renderer renderer_;
  render::SurfacePainter surfaces_;
  render::LinePainter lines_;
  Side original_, result_;
  Points plan_lines_, plan_targets_;
  std::size_t edition_ = 1, models_ = 0;
};

/// What a picture of the views shows.
/// \param pixel  width of a thin line.
Sight sight(const Session& session, const Scene& scene, const View& view, const Rect& area, float pixel);

/// The distance that gets the last heat colour.
double heat_top(const Session& session, const View& view);

}  // namespace whittle::viewer
