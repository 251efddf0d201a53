/// \file
/// An OpenMesh decimater while modules are added to it.
#pragma once

#include <OpenMesh/Tools/Decimater/BaseDecimaterT.hh>

#include "recipe/OpenMeshCopy.hh"
#include "whittle/openmesh/DriverT.hh"

namespace whittle::recipe {

/// Adds a module and gives access to it. The decimater owns it, so the handle need not live on.
template <typename Module, typename Decimater>
Module& add_module(Decimater& decimater) {
  typename Module::Handle handle;
  decimater.add(handle);
  return decimater.module(handle);
}

class StockDecimater {
 public:
  using Mesh = OpenMeshCopy::Mesh;
  using Decimater = OpenMesh::Decimater::BaseDecimaterT<Mesh>;
  using Weights = OpenMesh::VPropHandleT<float>;

  /// \param weights  of the vertices, for modules that know some; invalid: all 1
  StockDecimater(Decimater& decimater, Weights weights) : decimater_(decimater), weights_(weights) {}

  Weights weights() const { return weights_; }

  template <typename Module>
  Module& add() {
    // Whittle's drivers have an add() of their own, which looks at what the module can do.
    if (auto* driver = dynamic_cast<DriverT<Mesh>*>(&decimater_)) return add_module<Module>(*driver);
    return add_module<Module>(decimater_);
  }

 private:
  Decimater& decimater_;
  Weights weights_;
};

}  // namespace whittle::recipe
