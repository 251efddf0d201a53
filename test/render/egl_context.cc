#include "egl/EglContext.hh"

#include <epoxy/gl.h>

#include "catch.hh"

using namespace whittle;

TEST_CASE("the context is OpenGL 3.3 core or later and says what it is") {
  const egl::EglContext context;
  CHECK(epoxy_gl_version() >= 33);
  GLint profile = 0;
  glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  CHECK((profile & GL_CONTEXT_CORE_PROFILE_BIT) != 0);
  CHECK(context.facts().renderer == reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
  CHECK_FALSE(context.facts().vendor.empty());
  CHECK_FALSE(context.facts().version.empty());
  CHECK_FALSE(context.facts().device.empty());
}

TEST_CASE("contexts can be made one after the other") {
  for (int i = 0; i < 3; ++i) {
    const egl::EglContext context;
    CHECK(glGetError() == GL_NO_ERROR);
  }
}

TEST_CASE("the software renderer can be requested of a context") {
  const egl::EglContext context({std::nullopt, true});
  INFO(context.facts().device << ": " << context.facts().renderer);
  CHECK(context.facts().device.find("hardware") == std::string::npos);
}

TEST_CASE("devices are numbered from zero, and one more does not exist") {
  const auto devices = egl::list_devices();
  for (std::size_t i = 0; i < devices.size(); ++i) CHECK(devices[i].number == i);
  try {
    const egl::EglContext context({devices.size(), false});
    FAIL("there is no such device");
  } catch (const egl::EglError& error) {
    const std::string text = error.what();
    CHECK(text.find("there is no EGL device " + std::to_string(devices.size())) == 0);
    CHECK(text.find("install libegl1") != std::string::npos);
    CHECK(text.find('\n') == std::string::npos);
  }
}
