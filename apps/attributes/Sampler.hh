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
  /// The value at the point of a face in which its corners have these shares; a normal gets its length of one.
  void add(std::uint32_t face, const std::array<double, 3>& shares);
  /// \}

  /// An attribute of the same kind with the values collected, and as many faces' corners.
  Attribute take(std::vector<IndexedMesh::Triangle> corners);

 private:
  void add_skin(std::uint32_t face, const std::array<double, 3>& shares);

  const Attribute& in_;
  const IndexedMesh& mesh_;
  Attribute out_;
};

}  // namespace whittle::attributes
