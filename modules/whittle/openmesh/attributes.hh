/// \file
/// What happens to normals, colours and texture coordinates when a vertex vanishes into another.
#pragma once

#include <OpenMesh/Core/Utils/vector_traits.hh>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "whittle/openmesh/convert.hh"
#include "whittle/surface/Surface.hh"

namespace whittle {

/// (1 - share) a + share b; rounded to the nearest where the type is integral, as in colours of bytes.
template <typename Scalar>
Scalar blend_scalar(Scalar a, Scalar b, double share) {
  const double value = (1 - share) * static_cast<double>(a) + share * static_cast<double>(b);
  if constexpr (std::is_integral_v<Scalar>)
    return static_cast<Scalar>(std::lround(value));
  else
    return static_cast<Scalar>(value);
}

/// The same for scalars and for vectors, component by component.
template <typename Value>
Value blend(const Value& a, const Value& b, double share) {
  if constexpr (std::is_arithmetic_v<Value>) {
    return blend_scalar(a, b, share);
  } else {
    Value out = a;
    for (int i = 0; i < static_cast<int>(OpenMesh::vector_traits<Value>::size_); ++i)
      (&out[0])[i] = blend_scalar((&a[0])[i], (&b[0])[i], share);
    return out;
  }
}

/// Blends the vertex attributes of `from` into those of `to`; only those that the mesh has. Normals stay of
/// unit length.
template <typename Mesh>
void blend_vertex_attributes(Mesh& mesh, typename Mesh::VertexHandle from, typename Mesh::VertexHandle to,
                             double share) {
  if (mesh.has_vertex_normals()) {
    auto normal = blend(mesh.normal(to), mesh.normal(from), share);
    double squares = 0;
    auto* components = &normal[0];
    for (int i = 0; i < 3; ++i)
      squares += static_cast<double>(components[i]) * static_cast<double>(components[i]);
    using Scalar = std::decay_t<decltype(normal[0])>;
    if (squares > 0) {
      for (int i = 0; i < 3; ++i)
        components[i] = static_cast<Scalar>(static_cast<double>(components[i]) / std::sqrt(squares));
      mesh.set_normal(to, normal);
    }
  }
  if (mesh.has_vertex_colors()) mesh.set_color(to, blend(mesh.color(to), mesh.color(from), share));
  if (mesh.has_vertex_texcoords1D())
    mesh.set_texcoord1D(to, blend(mesh.texcoord1D(to), mesh.texcoord1D(from), share));
  if (mesh.has_vertex_texcoords2D())
    mesh.set_texcoord2D(to, blend(mesh.texcoord2D(to), mesh.texcoord2D(from), share));
  if (mesh.has_vertex_texcoords3D())
    mesh.set_texcoord3D(to, blend(mesh.texcoord3D(to), mesh.texcoord3D(from), share));
}

/// Adds a mesh's vertex normals, colours and texture coordinates to what a planner is told, times their
/// weights; only those that the mesh has.
template <typename Mesh>
void add_values(const Mesh& mesh, const ValueWeights& weights, SurfaceExtras& extras) {
  const std::size_t n = mesh.n_vertices();
  const auto add = [&](double weight, auto get) {
    using Value = std::decay_t<decltype(get(typename Mesh::VertexHandle(0)))>;
    using Component = typename OpenMesh::vector_traits<Value>::value_type;
    constexpr std::size_t size = OpenMesh::vector_traits<Value>::size_;
    const double full = std::is_integral_v<Component> ? double(std::numeric_limits<Component>::max()) : 1;
    const std::size_t old = extras.n_values, all = old + size;
    std::vector<float> values(all * n);
    for (std::size_t v = 0; v < n; ++v) {
      const auto value = get(typename Mesh::VertexHandle(static_cast<int>(v)));
      for (std::size_t i = 0; i < old; ++i) values[all * v + i] = extras.values[old * v + i];
      for (std::size_t i = 0; i < size; ++i)
        values[all * v + old + i] = static_cast<float>(weight * static_cast<double>((&value[0])[i]) / full);
    }
    extras.values = std::move(values);
    extras.n_values = all;
  };
  if (weights.normals > 0 && mesh.has_vertex_normals())
    add(weights.normals, [&](auto v) { return mesh.normal(v); });
  if (weights.colours > 0 && mesh.has_vertex_colors())
    add(weights.colours, [&](auto v) { return mesh.color(v); });
  if (weights.texture > 0 && mesh.has_vertex_texcoords2D())
    add(weights.texture, [&](auto v) { return mesh.texcoord2D(v); });
}

/// Carries one kind of half-edge texture coordinate over a collapse. OpenMesh lets the half-edges that
/// pointed to `v0` point to `v1` and leaves them the coordinate of `v0`.
template <typename Value>
class CornerCoordinates {
 public:
  /// Before the collapse. `v0` is on no seam, so one value holds all around it; `v1` may be, and the value
  /// that counts is that of the faces at the edge.
  template <typename Mesh, typename Get>
  void read(const Mesh& mesh, typename Mesh::HalfedgeHandle v0v1, Get get) {
    const auto v1v0 = mesh.opposite_halfedge_handle(v0v1);
    const bool left = !mesh.is_boundary(v0v1);
    at_v1_ = get(left ? v0v1 : mesh.prev_halfedge_handle(v1v0));
    at_v0_ = get(left ? mesh.prev_halfedge_handle(v0v1) : v1v0);
  }

  /// After it: what the corner at `v1` has where the half-edge pointed to `v0` before.
  Value blended(double share) const { return blend(at_v1_, at_v0_, share); }

 private:
  Value at_v0_{}, at_v1_{};
};

/// All half-edge texture coordinates of a mesh over a collapse; only those that the mesh has.
template <typename Mesh>
class CornerAttributes {
 public:
  void before(const Mesh& mesh, typename Mesh::HalfedgeHandle v0v1) {
    corners_.clear();
    if (!has_any(mesh)) return;
    const auto v0 = mesh.from_vertex_handle(v0v1);
    for (auto h = mesh.cvih_iter(v0); h.is_valid(); ++h) corners_.push_back(*h);
    if (mesh.has_halfedge_texcoords1D()) one_.read(mesh, v0v1, [&](auto h) { return mesh.texcoord1D(h); });
    if (mesh.has_halfedge_texcoords2D()) two_.read(mesh, v0v1, [&](auto h) { return mesh.texcoord2D(h); });
    if (mesh.has_halfedge_texcoords3D()) three_.read(mesh, v0v1, [&](auto h) { return mesh.texcoord3D(h); });
  }

  void after(Mesh& mesh, typename Mesh::VertexHandle v1, double share) {
    if (!has_any(mesh)) return;
    if (share > 0) {  // v1 has moved, so it is free, so it is on no seam: all its corners take the new value
      corners_.clear();
      for (auto h = mesh.vih_iter(v1); h.is_valid(); ++h) corners_.push_back(*h);
    }
    for (const auto h : corners_) {
      if (mesh.to_vertex_handle(h) != v1) continue;
      if (mesh.has_halfedge_texcoords1D()) mesh.set_texcoord1D(h, one_.blended(share));
      if (mesh.has_halfedge_texcoords2D()) mesh.set_texcoord2D(h, two_.blended(share));
      if (mesh.has_halfedge_texcoords3D()) mesh.set_texcoord3D(h, three_.blended(share));
    }
  }

 private:
  static bool has_any(const Mesh& mesh) {
    return mesh.has_halfedge_texcoords1D() || mesh.has_halfedge_texcoords2D() ||
           mesh.has_halfedge_texcoords3D();
  }

  std::vector<typename Mesh::HalfedgeHandle> corners_;  // those that point to v0 before the collapse
  CornerCoordinates<typename Mesh::TexCoord1D> one_;
  CornerCoordinates<typename Mesh::TexCoord2D> two_;
  CornerCoordinates<typename Mesh::TexCoord3D> three_;
};

}  // namespace whittle
