#include "window/FrameTiming.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/Camera.hh"

namespace whittle::viewer {
namespace {

constexpr std::size_t kSamples = 5;
constexpr int kSize = 512;
constexpr double kPiece = 40;  // milliseconds: for so long the window can wait

using Mesh = std::shared_ptr<const render::MeshBuffers>;

/// A frame in so many pieces of equal size; in none at all, as Painting finds them.
Painting frame(const Scene& scene, const Mesh& mesh, const Eigen::AlignedBox3d& box, std::size_t pieces) {
  const auto draw = [&renderer = scene.renderer(), mesh,
                     camera = render::frame(box, box, 1)](render::Part part) {
    const render::Look colours;
    if (part.first == 0) render::clear(colours);
    renderer.draw_part(*mesh, camera, colours, part);
  };
  std::vector<Stroke> strokes;
  if (pieces == 0)
    strokes.push_back({mesh->triangles(), [=](std::size_t first, std::size_t count) {
                         draw({first, count});
                       }});
  for (std::size_t i = 0; i < pieces; ++i) {
    const std::size_t first = mesh->triangles() * i / pieces, end = mesh->triangles() * (i + 1) / pieces;
    strokes.push_back({1, [=](std::size_t, std::size_t) { draw({first, end - first}); }});
  }
  return Painting(std::move(strokes));
}

}  // namespace

bool FrameTiming::wanting(const Scene& scene, Which which) const {
  const Mesh mesh = scene.mesh(which);
  return mesh && (side(which).mesh.lock() != mesh || side(which).samples.size() < kSamples);
}

bool FrameTiming::wanting(const Scene& scene) const {
  return wanting(scene, Which::original) || wanting(scene, Which::result);
}

void FrameTiming::advance(const Scene& scene, const Session& session, const Painting::Clock& clock) {
  if (!wanting(scene) || !session.model()) return;
  const Which which = wanting(scene, Which::original) ? Which::original : Which::result;
  const Mesh mesh = scene.mesh(which);
  Side& now = side(which);
  if (now.mesh.lock() != mesh) now = Side{mesh, Painting(), std::nullopt, {}};

  if (!framebuffer_) framebuffer_.emplace(kSize, kSize);
  framebuffer_->bind();
  glDisable(GL_SCISSOR_TEST);
  if (now.frame.done()) {
    const double pieces = now.first ? std::max(std::ceil(*now.first / kPiece), 1.0) : 0;
    now.frame = frame(scene, mesh, session.model()->box(), static_cast<std::size_t>(pieces));
  }
  now.frame.advance(kPiece, clock);
  if (!now.frame.done()) return;
  if (now.first)
    now.samples.push_back(now.frame.milliseconds());
  else
    now.first = now.frame.milliseconds();
  now.frame = Painting();
  if (!wanting(scene)) framebuffer_.reset();
}

std::optional<double> FrameTiming::milliseconds(const Scene& scene, Which which) const {
  if (!scene.mesh(which) || wanting(scene, which)) return std::nullopt;
  std::vector<double> samples = side(which).samples;
  std::sort(samples.begin(), samples.end());
  return samples[samples.size() / 2];
}

}  // namespace whittle::viewer
