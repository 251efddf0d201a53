/// \file
/// The bulk executor: a plan carried out on flat arrays in one go.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "whittle/plan/CollapsePlan.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle {

/// A mesh after a plan, and where its parts come from.
template <typename Real>
struct ExecutedT {
  IndexedMeshT<Real> mesh;                 ///< vertices and faces in their old order
  std::vector<std::uint32_t> vertex_map;   ///< for each old vertex the new vertex that it became
  std::vector<std::uint32_t> face_origin;  ///< for each new face the old face that it was
  std::vector<bool> survives;              ///< for each old vertex whether it still stands, moved or not
};

namespace detail {

/// Where the survivor of the last of `n_collapses` lies, which are in the middle of a cluster.
template <typename Real>
typename IndexedMeshT<Real>::Point place_of_last_part(const CollapsePlan& plan,
                                                      const IndexedMeshT<Real>& mesh,
                                                      std::size_t n_collapses) {
  std::size_t first = n_collapses - 1;
  while (first > 0 && plan.collapses[first - 1].rest > 0) --first;
  const auto place_before = [&](std::uint32_t v) {
    for (std::size_t i = first; i-- > 0;)
      if (plan.collapses[i].to == v)
        return typename IndexedMeshT<Real>::Point(plan.collapses[i].target.template cast<Real>());
    return mesh.points[v];
  };
  typename IndexedMeshT<Real>::Point place = place_before(plan.collapses[first].to);
  for (std::size_t i = first; i < n_collapses; ++i)
    place = place_of_part<Real>(place, place_before(plan.collapses[i].from), plan.collapses[i].target,
                                i - first + 2);
  return place;
}

/// The faces that are left where vertices have merged, in their old order, and which face each was. Those that had a vertex
/// twice before stay.
/// \param vertex_map  for each old vertex the new one that it became
template <typename Triangles>
void append_left(const Triangles& old_triangles, const std::vector<std::uint32_t>& vertex_map,
                 Triangles& left, std::vector<std::uint32_t>& origin) {
  for (std::uint32_t f = 0; f < old_triangles.size(); ++f) {
    const auto& old = old_triangles[f];
    const typename Triangles::value_type t{vertex_map[old[0]], vertex_map[old[1]], vertex_map[old[2]]};
    const bool vanished = (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) &&
                          !(old[0] == old[1] || old[1] == old[2] || old[2] == old[0]);
    if (vanished) continue;
    left.push_back(t);
    origin.push_back(f);
  }
}

}  // namespace detail

/// Carries out the first `n_collapses` of a plan, all by default. The plan must have been made for this mesh.
template <typename Real>
ExecutedT<Real> execute(const CollapsePlan& plan, const IndexedMeshT<Real>& mesh,
                        std::size_t n_collapses = ~std::size_t{0}) {
  n_collapses = std::min(n_collapses, plan.collapses.size());
  ExecutedT<Real> out;
  std::vector<std::uint32_t> survivor(mesh.points.size());
  std::iota(survivor.begin(), survivor.end(), 0u);
  for (std::size_t i = n_collapses; i-- > 0;)  // backwards, so that a later end of `to` is known already
    survivor[plan.collapses[i].from] = survivor[plan.collapses[i].to];

  std::size_t removed = 0;
  for (std::size_t i = 0; i < n_collapses; ++i) removed += plan.collapses[i].faces;
  const std::size_t n_faces = mesh.triangles.size() - std::min(removed, mesh.triangles.size());
  out.mesh.points.reserve(mesh.points.size() - n_collapses);
  out.mesh.triangles.reserve(n_faces);
  out.face_origin.reserve(n_faces);

  out.vertex_map.resize(mesh.points.size());
  out.survives.resize(mesh.points.size());
  for (std::uint32_t v = 0; v < survivor.size(); ++v) {
    out.survives[v] = survivor[v] == v;
    if (!out.survives[v]) continue;
    out.vertex_map[v] = static_cast<std::uint32_t>(out.mesh.points.size());
    out.mesh.points.push_back(mesh.points[v]);
  }
  for (std::uint32_t v = 0; v < survivor.size(); ++v) out.vertex_map[v] = out.vertex_map[survivor[v]];
  // One that goes later itself moves what it goes into, too, but not as the last one.
  for (std::size_t i = 0; i < n_collapses; ++i) {
    const Collapse& collapse = plan.collapses[i];
    out.mesh.points[out.vertex_map[collapse.to]] = collapse.target.template cast<Real>();
  }
  if (n_collapses > 0 && plan.collapses[n_collapses - 1].rest > 0)
    out.mesh.points[out.vertex_map[plan.collapses[n_collapses - 1].to]] =
        detail::place_of_last_part(plan, mesh, n_collapses);

  detail::append_left(mesh.triangles, out.vertex_map, out.mesh.triangles, out.face_origin);
  return out;
}

}  // namespace whittle
