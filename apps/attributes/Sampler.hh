/// \file
/// Values of an attribute between the vertices of a mesh.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "attributes/Attribute.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::attributes {

/// Collects values of an attribute, some as they are and some interpolated.
class Sampler {
 public:
  /// Both must outlive it. \pre the attribute fits the mesh
  Sampler(const Attribute& attribute, const IndexedMesh& mesh);

  std::uint32_t n_values() const { return static_cast<std::uint32_t>(out_.n_values()); }

  /// \name Each adds one.
  /// \{
  void copy(std::uint32_t value);
  /// The value at the point of these faces that is nearest to `p`. \pre there are some
  void interpolate(const Eigen::Vector3d& p, const std::vector<std::uint32_t>& faces);
  /// The value at a share of the way from one to another.
  void between(std::uint32_t from, std::uint32_t to, double share);
  /// \}

  /// An attribute of the same kind with the values collected, and as many faces' corners.
  Attribute take(std::vector<IndexedMesh::Triangle> corners);

 private:
  /// A normal gets its length of one, or is the fallback where it has none.
  void add(std::array<double, 4> value, std::uint32_t fallback);

  const Attribute& in_;
  const IndexedMesh& mesh_;
  Attribute out_;
};

}  // namespace whittle::attributes
