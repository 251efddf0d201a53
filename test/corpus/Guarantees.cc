#include "Guarantees.hh"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <algorithm>

#include "whittle/openmesh/convert.hh"

namespace whittle::corpus {
namespace {

bool is_usable(const IndexedMesh& mesh) {
  const auto in_range = [&](const IndexedMesh::Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return v < mesh.points.size(); });
  };
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), in_range) &&
         std::all_of(mesh.points.begin(), mesh.points.end(), [](const auto& p) { return p.allFinite(); });
}

bool is_map(const std::vector<std::uint32_t>& map, const IndexedMesh& from, const IndexedMesh& to) {
  return map.size() == from.points.size() &&
         std::all_of(map.begin(), map.end(), [&](std::uint32_t v) { return v < to.points.size(); });
}

/// Whether no module has its flip guard turned off.
bool is_guarded(const recipe::Recipe& recipe) {
  return std::none_of(recipe.modules.begin(), recipe.modules.end(),
                      [](const auto& module) { return module.number("guard").value_or(0) <= -1; });
}

/// Whether a driver refused some of what was planned; then what was to come after may be missing.
bool is_in_part(const recipe::Result& result) {
  return std::any_of(result.stages.begin(), result.stages.end(),
                     [](const auto& stage) { return stage.refused_by_decimater > 0; });
}

/// Whether faces were left out after a decimation that kept them: of which mesh the result is then the
/// distance is not measured.
bool is_cut_late(const recipe::Result& result) {
  return result.refused_faces > 0 && result.stages.front().driver == recipe::Driver::bulk;
}

}  // namespace

IndexedMesh as_openmesh_takes_it(const IndexedMesh& mesh) {
  OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble> taken;
  ::omerr().disable();
  to_openmesh(mesh, taken);
  ::omerr().enable();
  return to_indexed(taken);
}

std::string broken(const Counted& before, const Counted& taken, const recipe::Recipe& recipe,
                   const recipe::Result& result) {
  std::string what;
  const auto check = [&](bool holds, const char* name) {
    if (!holds) what += (what.empty() ? "" : ", ") + std::string(name);
  };
  check(is_usable(result.mesh), "index or coordinate");
  if (!what.empty()) return what;

  const measure::MeshFacts after = measure::facts(result.mesh);
  const measure::MeshFacts& old = (result.refused_faces == 0 ? before : taken).facts;
  check(is_map(result.vertex_map, before.mesh, result.mesh), "vertex map");
  if (is_cut_late(result)) return what;
  check(after.faces <= old.faces, "more faces");
  check(after.nonmanifold_edges <= old.nonmanifold_edges, "non-manifold edges");
  check(after.nonmanifold_vertices <= old.nonmanifold_vertices, "non-manifold vertices");
  check(after.duplicate_faces <= old.duplicate_faces, "duplicate faces");
  check(result.flipped_faces == 0 || is_in_part(result) || !is_guarded(recipe), "flipped faces");
  check(after.euler_characteristic == old.euler_characteristic, "Euler characteristic");
  check(after.boundary_loops == old.boundary_loops, "boundary loops");
  check(after.components == old.components, "components");
  check(result.target_reached || !recipe::reasons(recipe, result).empty(), "target missed without a reason");
  return what;
}

}  // namespace whittle::corpus
