#include "render/HeatPainter.hh"

#include "catch.hh"
#include "egl/EglContext.hh"
#include "render/Framebuffer.hh"
#include "triangles.hh"

using namespace whittle;

namespace {

std::array<std::uint8_t, 4> painted(float value) {
  const render::HeatPainter painter;
  const render::Framebuffer framebuffer(32, 32);
  const auto mesh = corner_triangle();
  painter.draw(render::MeshBuffers(mesh, std::vector<float>(mesh.points.size(), value)), {});
  return framebuffer.read().at(12, 20);
}

}  // namespace

TEST_CASE("heat colours run from violet without error to yellow at the most and beyond") {
  const egl::EglContext context;
  const auto none = painted(0), half = painted(0.5), most = painted(1), beyond = painted(7);
  CHECK(none[2] > none[1]);
  CHECK(half[1] > half[0]);
  CHECK(most[0] > 200);
  CHECK(most[1] > 200);
  CHECK(most[2] < 100);
  CHECK(beyond == most);
}
