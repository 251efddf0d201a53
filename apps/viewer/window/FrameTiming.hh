/// \file
/// How long the benchmark's renderer takes for a frame of each mesh.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "model/Painting.hh"
#include "render/Framebuffer.hh"
#include "window/Scene.hh"

namespace whittle::viewer {

/// Some frames of 512 by 512 pixels of each mesh that is new. A frame that takes long is drawn in pieces,
/// with the window's own frames between them, and the pieces' times are added up.
class FrameTiming {
 public:
  /// Whether there is still something to time.
  bool wanting(const Scene& scene) const;

  /// Draws a piece of that: to be called when there is nothing else to do.
  void advance(const Scene& scene, const Session& session, const Painting::Clock& clock);

  /// The median; none before all frames are drawn.
  std::optional<double> milliseconds(const Scene& scene, Which which) const;

 private:
  struct Side {
    std::weak_ptr<const render::MeshBuffers> mesh;
    Painting frame;
    std::optional<double> first;  ///< how long the first frame took, which only warms up
    std::vector<double> samples;
  };
  bool wanting(const Scene& scene, Which which) const;
  Side& side(Which which) { return which == Which::original ? original_ : result_; }
  const Side& side(Which which) const { return which == Which::original ? original_ : result_; }

  Side original_, result_;
  std::optional<render::Framebuffer> framebuffer_;  ///< while there is something to time
};

}  // namespace whittle::viewer
