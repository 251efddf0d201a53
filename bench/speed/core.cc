#include "speed/core.hh"

#include <dlfcn.h>

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace whittle::speed {
namespace {

/// The file that holds the code of `PolyConnectivity::add_face`, which is never inline.
std::string library_path() {
  using Add =
      OpenMesh::SmartFaceHandle (OpenMesh::PolyConnectivity::*)(const OpenMesh::VertexHandle*, size_t);
  const Add member = &OpenMesh::PolyConnectivity::add_face;
  void* code = nullptr;  // a pointer to a member that is not virtual begins with the address
  static_assert(sizeof member >= sizeof code);
  __builtin_memcpy(&code, &member, sizeof code);
  Dl_info info{};
  return dladdr(code, &info) != 0 && info.dli_fname ? info.dli_fname : "";
}

bool contains(const std::string& path, const char* text) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  return bytes.find(text) != std::string::npos;
}

}  // namespace

OpenMeshCore openmesh_core() {
  const std::string path = library_path();
  if (path.empty()) return {"unknown", false, "unknown"};
  OpenMeshCore core;
  core.file = std::filesystem::path(path).filename().string();
  core.assertions = contains(path, "__assert_fail");
  core.label = core.assertions ? "with assertions" : "without assertions";
  return core;
}

}  // namespace whittle::speed
