#include "render/Framebuffer.hh"

#include <set>

#include "catch.hh"
#include "egl/EglContext.hh"
#include "render/Renderer.hh"
#include "triangles.hh"

using namespace whittle;

namespace {

std::size_t colours(int samples) {
  const render::Renderer renderer;
  const render::Framebuffer framebuffer(16, 16, samples);
  renderer.draw(render::MeshBuffers(corner_triangle()), {});
  const auto image = framebuffer.read();
  std::set<std::array<std::uint8_t, 4>> found;
  for (int i = 0; i < 256; ++i) found.insert(image.at(i % 16, i / 16));
  return found.size();
}

}  // namespace

TEST_CASE("a framebuffer with several samples a pixel blends edges") {
  const egl::EglContext context;
  CHECK(colours(4) > colours(1));
}

TEST_CASE("a framebuffer's image has the requested width and its rows from the top") {
  const egl::EglContext context;
  const render::Framebuffer framebuffer(5, 3);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_SCISSOR_TEST);
  glScissor(4, 2, 1, 1);  // upper right, in OpenGL's rows from below
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  const auto image = framebuffer.read();
  CHECK(image.width == 5);
  CHECK(image.height == 3);
  REQUIRE(image.rgba.size() == 60);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 5; ++x) CHECK(image.at(x, y)[0] == (x == 4 && y == 0 ? 255 : 0));
}

TEST_CASE("a framebuffer of impossible size is an error") {
  const egl::EglContext context;
  CHECK_THROWS_AS(render::Framebuffer(0, 16), render::RenderError);
  CHECK_THROWS_AS(render::Framebuffer(16, 1 << 20), render::RenderError);
}

TEST_CASE("a picture is copied to its place in another one, smoothed on the way") {
  const egl::EglContext context;
  const render::Renderer renderer;
  const render::Framebuffer large(40, 30), smooth(16, 16, 4), plain(16, 16);
  const render::MeshBuffers mesh(corner_triangle());
  smooth.bind();
  renderer.draw(mesh, {});
  const auto expected = smooth.read();
  smooth.copy_to(plain.name(), 0, 0);
  CHECK(plain.read().rgba == expected.rgba);
  large.bind();
  glClear(GL_COLOR_BUFFER_BIT);
  plain.copy_to(large.name(), 20, 3);
  const auto image = large.read();
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) CHECK(image.at(20 + x, 30 - 3 - 16 + y) == expected.at(x, y));
  plain.copy_to(large.name(), 32, 20);  // what does not fit is cut off
  CHECK(large.read().at(39, 0) == expected.at(7, 6));
}
