/// \file
/// What a planner is told of an OpenMesh mesh besides its points and faces.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "whittle/openmesh/components.hh"
#include "whittle/openmesh/convert.hh"
#include "whittle/surface/Surface.hh"

namespace whittle::detail {

/// Calls `visit(get)` for each kind of half-edge texture coordinate that the mesh has.
template <typename Mesh, typename Visit>
void for_each_corner_kind(const Mesh& mesh, Visit visit) {
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;
  if (mesh.has_halfedge_texcoords1D()) visit([&](HalfedgeHandle h) { return mesh.texcoord1D(h); });
  if (mesh.has_halfedge_texcoords2D()) visit([&](HalfedgeHandle h) { return mesh.texcoord2D(h); });
  if (mesh.has_halfedge_texcoords3D()) visit([&](HalfedgeHandle h) { return mesh.texcoord3D(h); });
}

template <typename Mesh>
bool has_corner_attributes(const Mesh& mesh) {
  return mesh.has_halfedge_texcoords1D() || mesh.has_halfedge_texcoords2D() ||
         mesh.has_halfedge_texcoords3D();
}

/// Whether two half-edges that point to a vertex have the same texture coordinates.
template <typename Mesh>
bool same_corner(const Mesh& mesh, typename Mesh::HalfedgeHandle a, typename Mesh::HalfedgeHandle b) {
  bool same = true;
  for_each_corner_kind(mesh, [&](auto get) { same = same && get(a) == get(b); });
  return same;
}

/// Whether the faces around a vertex disagree about its texture coordinate. False for a mesh without
/// half-edge texture coordinates.
template <typename Mesh>
bool is_on_seam(const Mesh& mesh, typename Mesh::VertexHandle v) {
  typename Mesh::HalfedgeHandle first;
  for (auto h = mesh.cvih_iter(v); h.is_valid(); ++h) {
    if (mesh.is_boundary(*h)) continue;
    if (!first.is_valid()) first = *h;
    if (!same_corner(mesh, *h, first)) return true;
  }
  return false;
}

/// Whether the two faces at an edge disagree about the texture coordinate of either of its ends. False at the
/// boundary.
template <typename Mesh>
bool is_seam(const Mesh& mesh, typename Mesh::HalfedgeHandle h) {
  const auto o = mesh.opposite_halfedge_handle(h);
  if (mesh.is_boundary(h) || mesh.is_boundary(o)) return false;
  return !same_corner(mesh, h, mesh.prev_halfedge_handle(o)) ||
         !same_corner(mesh, o, mesh.prev_halfedge_handle(h));
}

/// For each half-edge a number of the corner that it points to: corners of a vertex that follow one another around it
/// have the same number if their texture coordinates agree. Empty where those of every vertex do: no seams.
template <typename Mesh>
std::vector<std::uint32_t> corner_numbers(const Mesh& mesh) {
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;
  if (!has_corner_attributes(mesh)) return {};
  std::vector<std::uint32_t> number(mesh.n_halfedges());
  const auto number_of = [&](HalfedgeHandle h) -> std::uint32_t& {
    return number[static_cast<std::size_t>(h.idx())];
  };
  std::uint32_t n_numbers = 0;
  bool has_seams = false;
  for (std::size_t v = 0; v < mesh.n_vertices(); ++v) {
    const HalfedgeHandle start = mesh.halfedge_handle(typename Mesh::VertexHandle(static_cast<int>(v)));
    HalfedgeHandle first, last;
    for (HalfedgeHandle out = start; out.is_valid();) {
      const HalfedgeHandle h = mesh.opposite_halfedge_handle(out);
      if (!mesh.is_boundary(h)) {
        if (last.is_valid() && same_corner(mesh, h, last)) {
          number_of(h) = number_of(last);
        } else if (last.is_valid() && same_corner(mesh, h, first)) {
          number_of(h) = number_of(first);
        } else {
          has_seams |= last.is_valid();
          number_of(h) = n_numbers++;
        }
        if (!first.is_valid()) first = h;
        last = h;
      }
      out = mesh.next_halfedge_handle(h);
      if (out == start) break;
    }
  }
  if (!has_seams) number.clear();
  return number;
}

/// The numbers at each face that is not deleted, as `SurfaceExtras::wedges` has them.
/// \param numbers  as `corner_numbers` makes them
/// \throw InvalidMesh  a face is not a triangle.
template <typename Mesh>
std::vector<std::array<std::uint32_t, 3>> corner_wedges(const Mesh& mesh,
                                                        const std::vector<std::uint32_t>& numbers) {
  std::vector<std::array<std::uint32_t, 3>> wedges;
  if (numbers.empty()) return wedges;
  wedges.reserve(mesh.n_faces());
  for_each_triangle(mesh, [&](std::size_t f, const auto&) {
    auto h = mesh.halfedge_handle(typename Mesh::FaceHandle(static_cast<int>(f)));
    auto& corners = wedges.emplace_back();
    for (std::uint32_t& corner : corners) {
      corner = numbers[static_cast<std::size_t>(h.idx())];
      h = mesh.next_halfedge_handle(h);
    }
    return true;
  });
  return wedges;
}

/// What the user has set for each vertex: locked, feature.
template <typename Mesh>
std::vector<std::uint8_t> user_flags(const Mesh& mesh) {
  std::vector<std::uint8_t> flags(mesh.n_vertices(), 0);
  if (!mesh.has_vertex_status()) return flags;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    const auto& status = mesh.status(typename Mesh::VertexHandle(static_cast<int>(i)));
    if (status.deleted()) continue;
    if (status.locked()) flags[i] |= kLocked;
    if (status.feature()) flags[i] |= kFeature;
  }
  return flags;
}

/// Adds a mesh's normals, colours and texture coordinates, of vertices and of half-edges, to the values that
/// a planner lets count, times their weights; only those that the mesh has. A vertex whose corners disagree
/// has no single value: not a number.
template <typename Mesh>
void add_values(const Mesh& mesh, const ValueWeights& weights, SurfaceExtras& extras) {
  using VertexHandle = typename Mesh::VertexHandle;
  const std::size_t n = mesh.n_vertices();
  /// `get(v)` is the value of a vertex; `has(v)` whether it has one.
  const auto add = [&](double weight, auto get, auto has) {
    using Value = std::decay_t<decltype(get(VertexHandle(0)))>;
    using Component = typename ComponentsT<Value>::Scalar;
    constexpr std::size_t size = ComponentsT<Value>::size;
    const double full = std::is_integral_v<Component> ? double(std::numeric_limits<Component>::max()) : 1;
    const std::size_t old = extras.n_values, all = old + size;
    std::vector<float> values(all * n, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < n; ++i) {
      const VertexHandle v(static_cast<int>(i));
      for (std::size_t k = 0; k < old; ++k) values[all * i + k] = extras.values[old * i + k];
      if (!has(v)) continue;
      const Value value = get(v);
      for (std::uint32_t k = 0; k < size; ++k)
        values[all * i + old + k] = static_cast<float>(weight * double(component(value, k)) / full);
    }
    extras.values = std::move(values);
    extras.n_values = all;
  };
  const auto always = [](VertexHandle) { return true; };
  if (weights.normals > 0 && mesh.has_vertex_normals())
    add(
        weights.normals, [&](VertexHandle v) { return mesh.normal(v); }, always);
  if (weights.colours > 0 && mesh.has_vertex_colors())
    add(
        weights.colours, [&](VertexHandle v) { return mesh.color(v); }, always);
  if (!(weights.texture > 0)) return;
  if (mesh.has_vertex_texcoords1D())
    add(
        weights.texture, [&](VertexHandle v) { return mesh.texcoord1D(v); }, always);
  if (mesh.has_vertex_texcoords2D())
    add(
        weights.texture, [&](VertexHandle v) { return mesh.texcoord2D(v); }, always);
  if (mesh.has_vertex_texcoords3D())
    add(
        weights.texture, [&](VertexHandle v) { return mesh.texcoord3D(v); }, always);
  const auto a_corner = [&](VertexHandle v) {
    for (auto h = mesh.cvih_iter(v); h.is_valid(); ++h)
      if (!mesh.is_boundary(*h)) return typename Mesh::HalfedgeHandle(*h);
    return typename Mesh::HalfedgeHandle();
  };
  for_each_corner_kind(mesh, [&](auto get) {
    add(
        weights.texture, [&](VertexHandle v) { return get(a_corner(v)); },
        [&](VertexHandle v) { return a_corner(v).is_valid() && !is_on_seam(mesh, v); });
  });
}

}  // namespace whittle::detail
