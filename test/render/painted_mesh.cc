#include "render/PaintedMesh.hh"

#include "catch.hh"
#include "egl/EglContext.hh"
#include "render/Framebuffer.hh"
#include "triangles.hh"

using namespace whittle;

namespace {

using CornersPaint = std::array<Eigen::Vector3f, 3>;

render::Image painted_picture(const IndexedMesh& mesh, const std::vector<CornersPaint>& corners,
                              render::Paint paint) {
  const render::PaintedRenderer renderer;
  const render::Framebuffer framebuffer(32, 32);
  renderer.draw(render::PaintedMesh(mesh, corners, paint), {});
  return framebuffer.read();
}

/// The same place in the texture at all corners of the triangle.
std::array<std::uint8_t, 4> checker_at(float u, float v) {
  const Eigen::Vector3f place(u, v, 0);
  return painted_picture(corner_triangle(), {{place, place, place}}, render::Paint::checker).at(12, 20);
}

}  // namespace

TEST_CASE("painted meshes have the colours of their corners, with those between them in between") {
  const egl::EglContext context;
  const Eigen::Vector3f red(1, 0, 0), blue(0, 0, 1);
  const auto plain = painted_picture(corner_triangle(), {{red, red, red}}, render::Paint::colours).at(12, 20);
  CHECK(plain[0] > 200);
  CHECK(plain[1] == 0);
  CHECK(plain[2] == 0);
  const auto mixed = painted_picture(corner_triangle(), {{red, blue, red}}, render::Paint::colours);
  CHECK(mixed.at(9, 22)[0] > mixed.at(22, 22)[0]);
  CHECK(mixed.at(9, 22)[2] < mixed.at(22, 22)[2]);
}

TEST_CASE("the checker of painted meshes has 32 squares a side, and a hue for each place") {
  const egl::EglContext context;
  const float square = 1.0F / 32;
  const auto light = [](const std::array<std::uint8_t, 4>& pixel) { return pixel[0] + pixel[1] + pixel[2]; };
  const auto first = checker_at(square / 2, square / 2);
  CHECK(std::abs(light(first) - light(checker_at(3 * square / 2, square / 2))) > 50);
  CHECK(std::abs(light(first) - light(checker_at(square / 2, 3 * square / 2))) > 50);
  CHECK(std::abs(light(first) - light(checker_at(3 * square / 2, 3 * square / 2))) < 50);
  CHECK(checker_at(30.5F * square, square / 2)[0] > 3 * first[0] / 2);
}

TEST_CASE("a checker finer than pixels is grey") {
  const egl::EglContext context;
  const auto image = painted_picture(
      corner_triangle(), {{Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(40, 0, 0), Eigen::Vector3f(0, 40, 0)}},
      render::Paint::checker);
  // Without the mean over a pixel neighbours differ by half of the range.
  int most = 0;
  for (int x = 10; x < 16; ++x) most = std::max(most, std::abs(image.at(x, 22)[2] - image.at(x + 1, 22)[2]));
  CHECK(most < 60);
}
