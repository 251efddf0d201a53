/// \file
/// The planned modules in any decimater that has OpenMesh's interface.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "speed/contenders/OpenMeshContender.hh"
#include "speed/contenders/contenders.hh"
#include "whittle/ModCircumcenterT.hh"
#include "whittle/ModFaceAngleT.hh"
#include "whittle/ModFassT.hh"
#include "whittle/ModSphereScanT.hh"
#include "whittle/ModVertexDistanceT.hh"
#include "whittle/ModVtdT.hh"

namespace whittle::speed {

template <typename Decimater, typename Module, typename Set>
Entry planned_entry(const std::string& method, const std::string& module, Set set) {
  Entry e;
  e.method = method;
  e.module = module;
  e.make = [set] {
    return std::make_unique<OpenMeshContender>([set](OpenMeshMesh& mesh) {
      Decimater decimater(mesh);
      set(add<Module>(decimater));
      decimater.initialize();
      decimater.decimate();
    });
  };
  return e;
}

template <typename Decimater>
std::vector<Entry> planned_entries(const std::string& method, const Subject& subject) {
  using Mesh = OpenMeshMesh;
  const double distance = kDistanceInEdges * subject.mean_edge, radius = kRadiusInEdges * subject.mean_edge;
  const auto nothing = [](auto&) {};
  const auto set_distance = [distance](auto& module) { module.set_max_distance(distance); };
  const auto set_radius = [radius](auto& module) { module.set_radius(radius); };
  return {planned_entry<Decimater, ModCircumcenterT<Mesh>>(method, "vt", nothing),
          planned_entry<Decimater, ModFaceAngleT<Mesh>>(method, "fad", nothing),
          planned_entry<Decimater, ModVertexDistanceT<Mesh>>(method, "ivdd", set_distance),
          planned_entry<Decimater, ModSphereScanT<Mesh>>(method, "ss", set_radius),
          planned_entry<Decimater, ModVtdT<Mesh>>(method, "vtd", set_distance),
          planned_entry<Decimater, ModFassT<Mesh>>(method, "fass", set_radius)};
}

}  // namespace whittle::speed
