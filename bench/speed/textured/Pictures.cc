#include "speed/textured/Pictures.hh"

#include <array>
#include <utility>

#include "experiment/Views.hh"
#include "fidelity/ImageDifference.hh"
#include "files/MeshFile.hh"
#include "render/Framebuffer.hh"

namespace whittle::speed {
namespace {

using attributes::Kind;

constexpr int kSamplesPerPixel = 4, kViewSide = 256, kPictureSide = 200;
constexpr std::size_t kViews = 8;

/// The corners' texture coordinates or colours, as the renderer takes them.
render::PaintedMesh painted(const IndexedMesh& mesh, const attributes::Attributes& attributes) {
  const attributes::Attribute* seen = nullptr;
  for (const auto& attribute : attributes)
    if (attribute.kind == Kind::texture || (!seen && attribute.kind == Kind::colour)) seen = &attribute;
  std::vector<std::array<Eigen::Vector3f, 3>> corners(
      mesh.triangles.size(), {Eigen::Vector3f::Ones(), Eigen::Vector3f::Ones(), Eigen::Vector3f::Ones()});
  for (std::size_t f = 0; seen && f < corners.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const float* value = seen->value(seen->at(mesh, f, k));
      corners[f][k] = seen->kind == Kind::colour
                          ? Eigen::Vector3f(value[0], value[1], value[2])
                          : Eigen::Vector3f(value[0], seen->downwards ? 1 - value[1] : value[1], 0);
    }
  return {mesh, corners,
          seen && seen->kind == Kind::texture ? render::Paint::checker : render::Paint::colours};
}

}  // namespace

Pictures::Pictures(std::filesystem::path folder) : folder_(std::move(folder)) {}

std::vector<render::Image> Pictures::views(const IndexedMesh& mesh,
                                           const attributes::Attributes& attributes) const {
  const render::Framebuffer framebuffer(kViewSide, kViewSide, kSamplesPerPixel);
  const render::PaintedMesh painting = painted(mesh, attributes);
  std::vector<render::Image> images;
  for (const render::Camera& camera : cameras_) {
    renderer_.draw(painting, camera);
    images.push_back(framebuffer.read());
  }
  return images;
}

std::string Pictures::begin(const TexturedModel& model) {
  name_ = model.name;
  cameras_ = bench::views_around(model.mesh, kViews);
  original_ = views(model.mesh, model.attributes);
  return write(model.mesh, model.attributes, "original");
}

double Pictures::psnr(const IndexedMesh& mesh, const attributes::Attributes& attributes) const {
  return bench::views_difference(original_, views(mesh, attributes)).psnr_db;
}

std::string Pictures::write(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                            const std::string& what) const {
  const render::Framebuffer framebuffer(kPictureSide, kPictureSide, kSamplesPerPixel);
  renderer_.draw(painted(mesh, attributes), cameras_.front());
  const std::string name = name_ + "-" + what + ".png";
  files::write_file(folder_ / name, render::encode_png(framebuffer.read(), name_ + ", " + what));
  return folder_.filename().string() + "/" + name;
}

}  // namespace whittle::speed
