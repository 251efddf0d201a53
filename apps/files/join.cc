#include "files/join.hh"

#include <Eigen/Geometry>
#include <cmath>

#include "files/Fault.hh"
#include "files/pairing.hh"
#include "files/places.hh"
#include "files/settle.hh"
#include "files/subset.hh"
#include "text/number.hh"

namespace whittle::files {
namespace {

void check_weld(const IndexedMesh& mesh, double weld) {
  if (!(weld >= 0 && std::isfinite(weld))) throw Fault("the weld must be a length, not negative");
  if (weld == 0) return;
  Eigen::AlignedBox3d box;
  for (const IndexedMesh::Point& point : mesh.points)
    if (point.allFinite()) box.extend(point);
  const double most = box.isEmpty() ? 0 : box.diagonal().norm() / 100;
  if (weld > most)
    throw Fault("a weld of " + text::shortest(weld) + " would join more than details: it may be at most " +
                text::significant(most, 3) + ", 1 % of the bounding box's diagonal");
}

/// Whether there is one that is not its own first.
bool names_another(const std::vector<std::uint32_t>& first) {
  for (std::uint32_t v = 0; v < first.size(); ++v)
    if (first[v] != v) return true;
  return false;
}

/// Leaves out faces whose corners become one.
void drop_collapsed(MeshFile& file, const std::vector<std::uint32_t>& root) {
  std::vector<bool> keep;
  keep.reserve(file.mesh.triangles.size());
  for (const auto& [a, b, c] : file.mesh.triangles)
    keep.push_back(root[a] != root[b] && root[b] != root[c] && root[c] != root[a]);
  file.report.dropped_degenerate += keep_faces(file, keep);
}

/// Puts one vertex in the place of those that are joined.
/// \param root  for each vertex the first of those that it is joined with
void merge(MeshFile& file, const std::vector<std::uint32_t>& root) {
  IndexedMesh& mesh = file.mesh;
  std::vector<std::uint32_t> first;  // of each vertex of the result, among those before
  std::vector<std::uint32_t> now(root.size());
  for (std::uint32_t v = 0; v < root.size(); ++v) {
    if (root[v] == v) {
      now[v] = static_cast<std::uint32_t>(first.size());
      mesh.points[first.size()] = mesh.points[v];
      first.push_back(v);
    } else {
      now[v] = now[root[v]];
    }
  }
  mesh.points.resize(first.size());
  const std::vector<IndexedMesh::Triangle> before = mesh.triangles;
  for (IndexedMesh::Triangle& triangle : mesh.triangles)
    for (std::uint32_t& corner : triangle) corner = now[corner];
  for (attributes::Attribute& attribute : file.attributes) {
    if (!attribute.per_vertex()) continue;
    attribute.corners = before;
    settle(attribute, mesh, first);
    if (attribute.kind == attributes::Kind::texture) file.texture_at_vertices |= !attribute.per_vertex();
  }
  for (std::uint32_t& vertex : file.vertex_of)
    if (vertex != MeshFile::left_out) vertex = now[vertex];
  if (file.vertex_of.empty()) file.vertex_of = std::move(now);
  file.report.merged_vertices += root.size() - first.size();
}

/// Vertices of faces that share their place with another one, but are not joined with it.
std::size_t count_apart(const IndexedMesh& mesh, const std::vector<std::uint32_t>& place,
                        const std::vector<std::uint32_t>& root) {
  std::vector<bool> used(root.size(), false);
  for (const IndexedMesh::Triangle& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) used[root[corner]] = true;
  std::vector<std::uint32_t> here(root.size(), 0);
  for (std::size_t v = 0; v < root.size(); ++v) here[place[v]] += used[v] ? 1 : 0;
  std::size_t apart = 0;
  for (const std::uint32_t n : here) apart += n > 1 ? n : 0;
  return apart;
}

}  // namespace

void join(MeshFile& file, const JoinOptions& options, std::vector<std::uint32_t> place) {
  check_weld(file.mesh, options.weld);
  if (options.weld > 0)
    place = near_places(file.mesh.points, options.weld);
  else if (place.empty())
    place = equal_places(file.mesh.points);
  if (!names_another(place) || file.mesh.triangles.empty()) return;
  const Joined joined = pair_and_join(file.mesh, place, options);
  file.report.vertices_apart = count_apart(file.mesh, place, joined.root);
  file.report.edges_left_open = joined.opposed;
  if (!names_another(joined.root)) return;
  drop_collapsed(file, joined.root);
  merge(file, joined.root);
}

}  // namespace whittle::files
