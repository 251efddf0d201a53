/// \file
/// What Whittle demands of OpenMesh and of a mesh's traits.
#pragma once

#include <OpenMesh/Core/System/config.h>
#include <OpenMesh/Core/Utils/vector_traits.hh>
#include <type_traits>

static_assert(OM_VERSION >= 0x90000, "Whittle needs OpenMesh 9 or newer");

namespace whittle::detail {

template <typename Mesh>
constexpr bool has_points_in_space = OpenMesh::vector_traits<typename Mesh::Point>::size_ == 3;

/// Refuses at compile time a mesh whose points do not have three coordinates of float or double.
template <typename Mesh>
constexpr void require_points_in_space() {
  static_assert(
      has_points_in_space<Mesh>,
      "Whittle needs points with three coordinates: in the mesh's traits, let Point be a vector such "
      "as OpenMesh::Vec3f or OpenMesh::Vec3d");
  static_assert(
      std::is_floating_point_v<typename Mesh::Scalar>,
      "Whittle moves points to places between those of the input: their coordinates must be float or double");
}

}  // namespace whittle::detail
