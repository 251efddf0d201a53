/// \file
/// Several planners as one OpenMesh decimater module.
#pragma once

#include "whittle/openmesh/ModPlannedT.hh"
#include "whittle/planners/Chain.hh"

namespace whittle {

/// Runs planners one after the other in one decimater, which takes only one priority module. Each is planned
/// on what those before it leave; all collapses of one come before those of the next.
///
/// <!-- test: header_chain -->
/// \code
/// whittle::ModChainT<Mesh, whittle::FaceAngle, whittle::VertexDistance>::Handle chain;
/// decimater.add(chain);
/// decimater.module(chain).change_planner<1>([](auto& ivdd) { ivdd.max_distance = 0.01; });
/// \endcode
/// \tparam Planners  Whittle's or your own; docs/write-your-own-planner.md shows what a planner is.
template <typename MeshT, typename... Planners>
class ModChainT : public ModPlannedT<MeshT, Chain<Planners...>> {
 public:
  using Self = ModChainT;
  using Handle = OpenMesh::Decimater::ModHandleT<Self>;
  using Base = OpenMesh::Decimater::ModBaseT<MeshT>;
  using Mesh = MeshT;
  using CollapseInfo = typename Base::CollapseInfo;
  DECIMATER_MODNAME(Chain)

  explicit ModChainT(MeshT& mesh) : ModPlannedT<MeshT, Chain<Planners...>>(mesh) {}

  /// Changes planner number I.
  /// \throw InvalidParameter  and all parameters stay.
  template <std::size_t I, typename Change>
  void change_planner(Change&& change) {
    this->change([&](Chain<Planners...>& chain) { change(std::get<I>(chain.planners)); });
  }
};

}  // namespace whittle
