#include "version/Version.hh"

#include <OpenMesh/Core/System/config.h>
#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "version/commit.hh"
#include "whittle/version.hh"

namespace whittle::version {
namespace {

std::string dotted(int a, int b, int c) {
  return std::to_string(a) + "." + std::to_string(b) + "." + std::to_string(c);
}

}  // namespace

std::string number() {
  return dotted(WHITTLE_VERSION_MAJOR, WHITTLE_VERSION_MINOR, WHITTLE_VERSION_PATCH);
}

std::string commit() {
  return kCommit;
}

bool dirty() {
  return kDirty;
}

std::string text(const std::string& program) {
  return program + " " + number() + " (commit " + commit() + (dirty() ? ", changed" : "") + ")\n" +
         "OpenMesh " + dotted(OM_VERSION >> 16, OM_VERSION >> 8 & 0xff, OM_VERSION & 0xff) + "\n" + "Eigen " +
         dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION) + "\n" + "CLI11 " +
         CLI11_VERSION + "\n" + "JSON for Modern C++ " +
         dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH);
}

}  // namespace whittle::version
