#include "files/repair.hh"

#include <algorithm>

#include "files/manifold.hh"
#include "files/settle.hh"
#include "files/subset.hh"
#include "whittle/surface/threads.hh"

namespace whittle::files {
namespace {

void drop_what_is_not_finite(MeshFile& file) {
  std::vector<bool> finite;
  finite.reserve(file.mesh.points.size());
  for (const IndexedMesh::Point& point : file.mesh.points) finite.push_back(point.allFinite());
  if (std::find(finite.begin(), finite.end(), false) == finite.end()) return;
  std::vector<bool> keep;
  keep.reserve(file.mesh.triangles.size());
  for (const auto& [a, b, c] : file.mesh.triangles) keep.push_back(finite[a] && finite[b] && finite[c]);
  file.report.broken_faces += keep_faces(file, keep);
  file.report.dropped_vertices += keep_vertices(file, finite);
}

void drop_unused_vertices(MeshFile& file) {
  if (file.mesh.triangles.empty()) return;  // a cloud of points is one on purpose
  std::vector<bool> used(file.mesh.points.size(), false);
  for (const IndexedMesh::Triangle& triangle : file.mesh.triangles)
    for (const std::uint32_t vertex : triangle) used[vertex] = true;
  file.report.dropped_vertices += keep_vertices(file, used);
}

std::vector<measure::Side> sides_of(const IndexedMesh& mesh) {
  return measure::sides_by_edge(mesh.triangles, mesh.points.size());
}

/// Marks the faces that are the first on their three vertices.
std::vector<bool> mark_distinct(const IndexedMesh& mesh, const std::vector<measure::Side>& sides) {
  const std::vector<std::uint32_t> first = first_alike(mesh.triangles, sides);
  std::vector<bool> distinct(first.size());
  for (std::uint32_t face = 0; face < first.size(); ++face) distinct[face] = first[face] == face;
  return distinct;
}

void count(MeshFile& file, const std::vector<measure::Side>& sides) {
  const NonManifold found = count_nonmanifold(file.mesh, sides);
  file.report.nonmanifold_edges = found.edges;
  file.report.nonmanifold_vertices = found.vertices;
}

/// Counts the faces that share no edge, if half of all are so.
void count_lone(MeshFile& file, const std::vector<measure::Side>& sides) {
  std::vector<std::uint8_t> open(file.mesh.triangles.size(), 0);
  for_each_edge(sides, [&](const measure::Side* begin, const measure::Side* end) {
    if (end - begin == 1) ++open[begin->face()];
  });
  const auto lone = static_cast<std::size_t>(std::count(open.begin(), open.end(), 3));
  if (open.size() > 1 && 2 * lone >= open.size()) file.report.lone_faces = lone;
}

void fix(MeshFile& file) {
  drop_what_is_not_finite(file);
  std::vector<measure::Side> sides = sides_of(file.mesh);
  file.report.duplicate_faces = keep_faces(file, mark_distinct(file.mesh, sides));
  if (file.report.duplicate_faces > 0) sides = sides_of(file.mesh);
  count(file, sides);
  count_lone(file, sides);
  if (file.report.nonmanifold_edges > 0) file.report.turned_faces = orient(file);
  if (file.report.nonmanifold_edges + file.report.nonmanifold_vertices > 0)
    file.report.copied_vertices = cut(file);
  drop_unused_vertices(file);

  // Corners may agree now that did not before, and values may be of no use any more.
  settle(file);
}

}  // namespace

void repair(MeshFile& file, Repair mode, Sides sides) {
  file.report.repair = mode;
  if (mode == Repair::fix) fix(file);
  if (mode != Repair::report) return;
  if (sides.empty()) sides = sides_of(file.mesh);
  // Each looks at the same sides for something else.
  detail::Crew crew(detail::thread_count(0) > 1 && file.mesh.triangles.size() > 1000 ? 2 : 1);
  crew.each(2, [&](std::size_t i) {
    if (i == 0) return count(file, sides);
    const std::vector<bool> distinct = mark_distinct(file.mesh, sides);
    file.report.duplicate_faces =
        static_cast<std::size_t>(std::count(distinct.begin(), distinct.end(), false));
    count_lone(file, sides);
  });
}

}  // namespace whittle::files
