#include "egl/EglContext.hh"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <link.h>

#include <algorithm>
#include <string_view>

namespace whittle::egl {
namespace {

constexpr char kAdvice[] =
    "on Debian install libegl1, libopengl0 and libgl1-mesa-dri, or the graphics card's driver";

bool loads(const char* library) {
  void* handle = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
  if (handle != nullptr) dlclose(handle);
  return handle != nullptr;
}

/// libepoxy loads these on first use and ends the process where they are missing, so we look first.
void require_libraries() {
  if (!loads("libEGL.so.1")) throw EglError(std::string("there is no EGL library (libEGL.so.1); ") + kAdvice);
  if (!loads("libOpenGL.so.0") && !loads("libGL.so.1"))
    throw EglError(std::string("there is no OpenGL library (libOpenGL.so.0); ") + kAdvice);
}

/// Whether a list of words apart by spaces, as EGL gives extensions, has this one.
bool has_word(const char* list, std::string_view word) {
  if (list == nullptr) return false;
  const std::string padded = " " + std::string(list) + " ";
  return padded.find(" " + std::string(word) + " ") != std::string::npos;
}

bool client_has(std::string_view extension) {
  return has_word(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), extension);
}

/// EGL's handles of its devices; their places in the list are the numbers we give them.
std::vector<EGLDeviceEXT> device_handles() {
  if (!client_has("EGL_EXT_device_base") &&
      !(client_has("EGL_EXT_device_enumeration") && client_has("EGL_EXT_device_query")))
    return {};
  EGLint count = 0;
  if (!eglQueryDevicesEXT(0, nullptr, &count) || count < 1) return {};
  std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
  if (!eglQueryDevicesEXT(count, devices.data(), &count)) return {};
  devices.resize(static_cast<std::size_t>(count));
  return devices;
}

bool is_software(EGLDeviceEXT device) {
  return has_word(eglQueryDeviceStringEXT(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
}

/// Names that Mesa and others give to renderers that run on the processor.
bool is_software_renderer(const std::string& renderer) {
  const auto names = {"llvmpipe", "softpipe", "swrast", "SwiftShader"};
  return std::any_of(names.begin(), names.end(),
                     [&](const char* name) { return renderer.find(name) != std::string::npos; });
}

/// One way to a display that may or may not work.
struct Attempt {
  EGLenum platform;
  void* native_display;
  std::string name;
  bool must_be_software;
};

/// What to try for a choice, best first.
std::vector<Attempt> attempts(const DeviceChoice& choice) {
  const auto handles = client_has("EGL_EXT_platform_device") ? device_handles() : std::vector<EGLDeviceEXT>();
  if (choice.number && *choice.number >= handles.size())
    throw EglError("there is no EGL device " + std::to_string(*choice.number) + "; EGL lists " +
                   std::to_string(handles.size()) + "; " + kAdvice);

  std::vector<Attempt> hardware, software;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    if (choice.number && *choice.number != i) continue;
    const bool soft = is_software(handles[i]);
    const std::string name = "EGL device " + std::to_string(i) + (soft ? " (software)" : " (hardware)");
    (soft ? software : hardware).push_back({EGL_PLATFORM_DEVICE_EXT, handles[i], name, false});
  }
  // The last resort, for a Mesa that does not list its software renderer. With a card it may take the card.
  if (!choice.number && client_has("EGL_MESA_platform_surfaceless"))
    software.push_back({EGL_PLATFORM_SURFACELESS_MESA, nullptr, "surfaceless platform", choice.software});

  if (!choice.software) software.insert(software.begin(), hardware.begin(), hardware.end());
  return software;
}

std::string gl_string(GLenum name) {
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text != nullptr ? text : "unknown";
}

EGLConfig any_config(EGLDisplay display) {
  // No surface is ever made, so the surface type is free; left out, it would ask for windows.
  const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &count) || count < 1)
    throw EglError("it has no configuration for OpenGL");
  return config;
}

int add_name(dl_phdr_info* library, std::size_t, void* names) {
  static_cast<std::vector<std::string>*>(names)->push_back(library->dlpi_name);
  return 0;
}

/// Keeps all libraries that are loaded now until the process ends. EGL would unload its driver with the
/// display, and what the driver has left allocated could then not be told apart from a leak of this program.
void pin_libraries() {
  std::vector<std::string> names;
  dl_iterate_phdr(add_name, &names);
  for (const auto& name : names) {
    if (!name.empty()) dlopen(name.c_str(), RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE);
  }
}

}  // namespace

std::vector<Device> list_devices() {
  require_libraries();
  std::vector<Device> devices;
  for (const auto handle : device_handles()) devices.push_back({devices.size(), is_software(handle)});
  return devices;
}

EglContext::EglContext(const DeviceChoice& choice) {
  require_libraries();
  std::string failures;
  for (const auto& attempt : attempts(choice)) {
    try {
      open(attempt.platform, attempt.native_display);
      facts_ = {gl_string(GL_RENDERER), gl_string(GL_VENDOR), gl_string(GL_VERSION), attempt.name};
      if (!attempt.must_be_software || is_software_renderer(facts_.renderer)) return;
      throw EglError("it is " + facts_.renderer + ", not software");
    } catch (const EglError& error) {
      close();
      failures += (failures.empty() ? " (" : ", ") + attempt.name + ": " + error.what();
    }
  }
  throw EglError("no EGL device gives an OpenGL 3.3 core context" + (failures.empty() ? "" : failures + ")") +
                 "; " + kAdvice);
}

EglContext::~EglContext() {
  close();
}

void EglContext::open(unsigned platform, void* native_display) {
  display_ = eglGetPlatformDisplayEXT(platform, native_display, nullptr);
  if (display_ == EGL_NO_DISPLAY) throw EglError("it gives no display");
  if (!eglInitialize(display_, nullptr, nullptr)) throw EglError("its driver does not start");
  if (!has_word(eglQueryString(display_, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
    throw EglError("it cannot draw without a window (EGL_KHR_surfaceless_context)");
  if (!eglBindAPI(EGL_OPENGL_API)) throw EglError("it has no OpenGL, only OpenGL ES");

  const EGLint version_3_3[] = {EGL_CONTEXT_MAJOR_VERSION,
                                3,
                                EGL_CONTEXT_MINOR_VERSION,
                                3,
                                EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                EGL_NONE};
  context_ = eglCreateContext(display_, any_config(display_), EGL_NO_CONTEXT, version_3_3);
  if (context_ == EGL_NO_CONTEXT) throw EglError("it refuses an OpenGL 3.3 core context");
  if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
    throw EglError("its context cannot be made current");
}

void EglContext::close() {
  if (display_ == EGL_NO_DISPLAY) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  pin_libraries();
  if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
  eglTerminate(display_);
  eglReleaseThread();
  display_ = EGL_NO_DISPLAY;
  context_ = EGL_NO_CONTEXT;
}

}  // namespace whittle::egl
