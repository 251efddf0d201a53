#include <iostream>

#include "program/commands.hh"

namespace whittle::bench {

int print_devices() {
  const auto devices = egl::list_devices();
  for (const auto& device : devices) {
    std::cout << device.number << "  " << (device.software ? "software" : "hardware") << "  ";
    try {
      const auto facts = egl::EglContext({device.number, false}).facts();
      std::cout << facts.renderer << "; OpenGL " << facts.version << "\n";
    } catch (const egl::EglError&) {
      std::cout << "does not give OpenGL 3.3\n";
    }
  }
  if (devices.empty()) std::cout << "EGL lists no devices; --device software may still work\n";
  return 0;
}

}  // namespace whittle::bench
