/// \file
/// An OpenGL context without a window system, through EGL.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace whittle::egl {

/// No context could be created. `what()` is one line: why, device by device, and what to install.
class EglError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One entry of EGL's own list of devices. Mesa lists its software renderer there too.
struct Device {
  std::size_t number = 0;  ///< as in DeviceChoice
  bool software = false;   ///< EGL marks it as Mesa's software renderer
};

/// The devices that EGL lists (`EGL_EXT_device_enumeration`), usable or not; none where it cannot list them.
/// \throw EglError  there is no EGL library.
std::vector<Device> list_devices();

/// Which device draws. By default the first hardware device that works, otherwise software.
struct DeviceChoice {
  std::optional<std::size_t> number;  ///< this device of list_devices() and no other
  bool software = false;              ///< the software renderer, even where there is hardware
};

/// What was really obtained, in the driver's words.
struct ContextFacts {
  std::string renderer, vendor, version;  ///< GL_RENDERER, GL_VENDOR, GL_VERSION
  std::string device;                     ///< "EGL device 0 (hardware)", "surfaceless platform"
};

/// An OpenGL 3.3 core context, current on the thread that made it until it is destroyed. It has no surface:
/// draw into framebuffer objects. Only one may exist at a time, since EGL shares displays behind the scenes.
class EglContext {
 public:
  /// \throw EglError  no EGL, no such device, or none that gives OpenGL 3.3.
  explicit EglContext(const DeviceChoice& choice = {});
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  const ContextFacts& facts() const { return facts_; }

 private:
  void open(unsigned platform, void* native_display);
  void close();

  void* display_ = nullptr;
  void* context_ = nullptr;
  ContextFacts facts_;
};

}  // namespace whittle::egl
