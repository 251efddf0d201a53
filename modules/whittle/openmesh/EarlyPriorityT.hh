/// \file
/// What LazyDecimaterT asks of a module whose priorities cost less than its tests.
#pragma once

#include <OpenMesh/Tools/Decimater/CollapseInfoT.hh>

namespace whittle {

/// A module that knows the priority of a collapse before it has tested whether the collapse is allowed. A driver that
/// looks for the best collapse of a vertex has only those tested that can be the best. At a vertex of n edges, where a
/// test looks at n faces, that is one test or a few instead of n.
template <typename MeshT>
class EarlyPriorityT {
 public:
  virtual ~EarlyPriorityT() = default;
  /// Whether its priorities decide the order; false in binary mode.
  virtual bool decides_order() const = 0;
  /// What collapse_priority() returns where it allows the collapse; negative where it certainly does not.
  virtual float early_priority(const OpenMesh::Decimater::CollapseInfoT<MeshT>& ci) = 0;
};

}  // namespace whittle
