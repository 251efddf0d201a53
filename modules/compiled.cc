/// \file
/// The target whittle::compiled: what takes longest to compile, for points of float and double.
#include <Eigen/Cholesky>

#include "whittle/planners/MemorylessQuadric.hh"
#include "whittle/planners/PlaneQuadric.hh"
#include "whittle/planners/pieces_by_error.hh"

namespace whittle {

Eigen::Vector3d detail::solve(const Eigen::Matrix3d& a, const Eigen::Vector3d& b) {
  return a.ldlt().solve(b);
}

template CollapsePlan MemorylessQuadric::plan_checked(const IndexedMeshT<float>&, const SurfaceExtras&,
                                                      std::size_t) const;
template CollapsePlan MemorylessQuadric::plan_checked(const IndexedMeshT<double>&, const SurfaceExtras&,
                                                      std::size_t) const;
template std::vector<bool> pieces_by_error(const IndexedMeshT<float>&, const Pieces&, SurfaceExtras,
                                           const TargetCount&, std::size_t);
template std::vector<bool> pieces_by_error(const IndexedMeshT<double>&, const Pieces&, SurfaceExtras,
                                           const TargetCount&, std::size_t);

}  // namespace whittle
