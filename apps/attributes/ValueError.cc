#include "attributes/ValueError.hh"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "measure/ClosestFace.hh"
#include "measure/Surface.hh"
#include "measure/triangle.hh"

namespace whittle::attributes {
namespace {

Eigen::Vector4d value_at(const IndexedMesh& mesh, const Attribute& attribute, std::uint32_t face,
                         const Eigen::Vector3d& point) {
  const auto share = measure::shares(measure::corners(mesh, mesh.triangles[face]), point);
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < attribute.components; ++i)
      sum[static_cast<Eigen::Index>(i)] +=
          share[k] * static_cast<double>(attribute.value(attribute.at(mesh, face, k))[i]);
  if (attribute.kind == Kind::normal && sum.norm() > 0) sum.normalize();
  return sum;
}

}  // namespace

ValueError value_error(const IndexedMesh& original, const Attribute& before, const IndexedMesh& simplified,
                       const Attribute& after, std::size_t samples) {
  const measure::Surface from(original), to(simplified);
  const measure::ClosestFace closest(to, 1);
  ValueError error;
  for (std::size_t i = 0; i < samples; ++i) {
    const Eigen::Vector3d p = from.sample(i, samples);
    const std::size_t nearest = closest.closest(p).face;
    const Eigen::Vector3d q = measure::closest_point(p, to.face(nearest));
    const double squared = (value_at(original, before, from.index(from.sampled_face(i, samples)), p) -
                            value_at(simplified, after, to.index(nearest), q))
                               .squaredNorm();
    error.rms += squared;
    error.max = std::max(error.max, squared);
  }
  error.rms = std::sqrt(error.rms / static_cast<double>(samples));
  error.max = std::sqrt(error.max);
  return error;
}

}  // namespace whittle::attributes
