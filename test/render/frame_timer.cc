#include "render/FrameTimer.hh"

#include <chrono>
#include <thread>

#include "catch.hh"
#include "egl/EglContext.hh"
#include "render/Framebuffer.hh"
#include "render/Renderer.hh"
#include "triangles.hh"

using namespace whittle;

TEST_CASE("the paper's frames are the 100th to the 1,100th, a thousand") {
  CHECK(render::FrameRange().from == 100);
  CHECK(render::FrameRange().to == 1100);
  CHECK(render::FrameRange().timed() == 1000);
}

TEST_CASE("every frame is drawn once, and the ones that warm up are not timed") {
  const egl::EglContext context;
  std::size_t drawn = 0;
  const auto slow_start = [&] {
    if (++drawn <= 3) std::this_thread::sleep_for(std::chrono::milliseconds(200));
  };
  const auto time = render::time_frames(slow_start, {3, 8});
  CHECK(drawn == 8);
  CHECK(time.wall_ms < 200);
}

TEST_CASE("the span holds the timed frames") {
  const egl::EglContext context;
  const auto pause = [] { std::this_thread::sleep_for(std::chrono::milliseconds(5)); };
  CHECK(render::time_frames(pause, {0, 4}).wall_ms >= 20);
}

TEST_CASE("OpenGL's own timer runs over the same span") {
  const egl::EglContext context;
  const render::Renderer renderer;
  const render::Framebuffer framebuffer(256, 256);
  const render::MeshBuffers mesh(corner_triangle());
  const auto time = render::time_frames([&] { renderer.draw(mesh, {}); }, {1, 50});
  REQUIRE(time.gl_ms);
  CHECK(*time.gl_ms > 0);
  CHECK(*time.gl_ms <= 1.05 * time.wall_ms);
}

TEST_CASE("a frame that throws ends the timing, and the next timing works") {
  const egl::EglContext context;
  int drawn = 0;
  const auto fails = [&] {
    if (++drawn == 4) throw std::runtime_error("stop");
  };
  CHECK_THROWS_AS(render::time_frames(fails, {2, 9}), std::runtime_error);
  CHECK(render::time_frames([] {}, {0, 2}).gl_ms.has_value());
  CHECK(glGetError() == GL_NO_ERROR);
}
