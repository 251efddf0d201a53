#include "render/Renderer.hh"

#include <cmath>

#include "catch.hh"
#include "egl/EglContext.hh"
#include "meshes.hh"
#include "render/Framebuffer.hh"
#include "triangles.hh"

using namespace whittle;
using Pixel = std::array<std::uint8_t, 4>;

namespace {

render::Image picture(const IndexedMesh& mesh, const render::Camera& camera, int size) {
  const render::Renderer renderer;
  const render::Framebuffer framebuffer(size, size);
  renderer.draw(render::MeshBuffers(mesh), camera);
  return framebuffer.read();
}

/// A camera at the origin whose box of sight is [-1, 1] on all axes, with OpenGL's depth: nearer is larger z.
render::Camera flat_camera() {
  render::Camera camera;
  camera.projection(2, 2) = -1;
  return camera;
}

Pixel background() {
  const render::Look look;
  const auto byte = [&](int i) { return static_cast<std::uint8_t>(std::lround(255 * look.background[i])); };
  return {byte(0), byte(1), byte(2), 255};
}

bool reddish(const Pixel& pixel) {
  return pixel[0] > 2 * pixel[1] && pixel[0] > 2 * pixel[2];
}

/// The clay: brighter in red than in blue, but far from the red of the inside.
bool clay(const Pixel& pixel) {
  return pixel[0] > pixel[2] && pixel[2] > pixel[0] / 2;
}

}  // namespace

TEST_CASE("a triangle covers exactly the pixels whose centres lie in it") {
  const egl::EglContext context;
  const auto image = picture(corner_triangle(), flat_camera(), 16);
  for (int row = 0; row < 16; ++row) {
    for (int x = 0; x < 16; ++x) {
      const int y = 15 - row;
      INFO("column " << x << ", row from below " << y);
      if (x >= 4 && y >= 4 && x + y <= 15)
        CHECK(clay(image.at(x, row)));
      else
        CHECK(image.at(x, row) == background());
    }
  }
}

TEST_CASE("an empty mesh leaves the background") {
  const egl::EglContext context;
  const auto image = picture({}, flat_camera(), 4);
  for (int i = 0; i < 16; ++i) CHECK(image.at(i % 4, i / 4) == background());
}

TEST_CASE("the renderer shows the nearer triangle, whichever is drawn first") {
  const egl::EglContext context;
  CHECK(clay(picture(front_then_back(0.5, -0.5), flat_camera(), 8).at(3, 3)));
  CHECK(reddish(picture(front_then_back(-0.5, 0.5), flat_camera(), 8).at(3, 3)));
}

TEST_CASE("the renderer draws the inner side of a surface red") {
  const egl::EglContext context;
  auto mesh = corner_triangle();
  std::swap(mesh.triangles[0][1], mesh.triangles[0][2]);
  CHECK(reddish(picture(mesh, flat_camera(), 16).at(5, 10)));
}

TEST_CASE("the light is brighter on what faces it") {
  const egl::EglContext context;
  auto upward = corner_triangle(), downward = corner_triangle();
  for (auto& p : upward.points) p.z() = -p.y();
  for (auto& p : downward.points) p.z() = p.y();
  CHECK(picture(upward, flat_camera(), 16).at(5, 10)[0] >
        picture(downward, flat_camera(), 16).at(5, 10)[0] + 20);
}

TEST_CASE("a model far from the origin looks as near it") {
  const egl::EglContext context;
  const auto view = [](const IndexedMesh& mesh) {
    const auto box = render::bounding_box(mesh);
    return picture(mesh, render::frame(box, box, 1), 64);
  };
  auto mesh = corner_triangle();
  const auto here = view(mesh);
  for (auto& p : mesh.points) p += Eigen::Vector3d(4e6, -2e6, 1e6);
  CHECK(view(mesh).rgba == here.rgba);
}

TEST_CASE("a mesh drawn part by part is the whole mesh") {
  const egl::EglContext context;
  const IndexedMesh mesh = meshes::torus(24, 16);
  const render::Framebuffer framebuffer(64, 64);
  const render::Renderer renderer;
  const render::MeshBuffers buffers(mesh);
  const Eigen::AlignedBox3d box = render::bounding_box(mesh);
  const render::Camera camera = render::frame(box, box, 1);
  renderer.draw(buffers, camera);
  const auto whole = framebuffer.read();
  render::clear({});
  for (std::size_t first = 0; first < buffers.triangles(); first += 100)
    renderer.draw_part(buffers, camera, {}, {first, 100});
  CHECK(framebuffer.read().rgba == whole.rgba);
  renderer.draw_part(buffers, camera, {}, {buffers.triangles(), 5});  // nothing is left
  CHECK(framebuffer.read().rgba == whole.rgba);
}
