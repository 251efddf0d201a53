#include "recipe/Decimated.hh"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "whittle/plan/merged_wedges.hh"

namespace whittle::recipe {

Decimated Decimated::unchanged(const IndexedMesh& mesh) {
  Decimated out;
  out.mesh = mesh;
  out.vertex_map.resize(mesh.points.size());
  std::iota(out.vertex_map.begin(), out.vertex_map.end(), 0u);
  out.face_origin.resize(mesh.triangles.size());
  std::iota(out.face_origin.begin(), out.face_origin.end(), 0u);
  return out;
}

void Decimated::then(Decimated&& next) {
  mesh = std::move(next.mesh);
  for (std::uint32_t& v : vertex_map) v = next.vertex_map[v];
  for (std::uint32_t& f : next.face_origin) f = face_origin[f];
  face_origin = std::move(next.face_origin);
  refused_faces += next.refused_faces;
}

void flag_seams(const IndexedMesh& mesh, SurfaceExtras& extras) {
  extras.flags.resize(mesh.points.size(), 0);
  if (extras.wedges.empty()) return;
  const std::vector<bool> seams = on_seams(mesh.triangles, extras.wedges, mesh.points.size());
  for (std::size_t v = 0; v < seams.size(); ++v)
    if (seams[v]) extras.flags[v] |= kSeam;
}

SurfaceExtras carried(const SurfaceExtras& extras, const IndexedMesh& before, const Decimated& decimated) {
  SurfaceExtras out;
  const std::size_t n = decimated.mesh.points.size();
  if (!extras.flags.empty()) out.flags.resize(n, 0);
  if (!extras.tolerance.empty()) out.tolerance.resize(n, HUGE_VALF);
  for (std::size_t v = 0; v < decimated.vertex_map.size(); ++v) {
    const std::uint32_t w = decimated.vertex_map[v];
    if (!extras.flags.empty()) out.flags[w] |= extras.flags[v];
    if (!extras.tolerance.empty()) out.tolerance[w] = std::min(out.tolerance[w], extras.tolerance[v]);
  }
  if (extras.wedges.empty()) return out;
  out.wedges = merged_wedges(
      {before.triangles, decimated.mesh.triangles, decimated.vertex_map, decimated.face_origin, n},
      extras.wedges);
  for (std::uint8_t& flags : out.flags) flags &= static_cast<std::uint8_t>(~kSeam);
  flag_seams(decimated.mesh, out);
  return out;
}

}  // namespace whittle::recipe
