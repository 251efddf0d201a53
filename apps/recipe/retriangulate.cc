#include <utility>

#include "recipe/OpenMeshCopy.hh"
#include "recipe/openmesh.hh"

namespace whittle::recipe {

IndexedMesh retriangulate(const IndexedMesh& mesh, double max_dihedral, DelaunayFlipsReport& report,
                          std::size_t& refused_faces, std::vector<IndexedMesh::Triangle>& wedges) {
  const Silence silence;
  OpenMeshCopy copy(mesh);
  if (!wedges.empty()) copy.set_wedges(mesh, wedges);
  DelaunayFlips options;
  options.max_dihedral = max_dihedral;
  report = delaunay_flips(copy.mesh, options);
  if (!wedges.empty()) {
    wedges.clear();
    for (const auto f : copy.mesh.faces()) {
      auto& corners = wedges.emplace_back();
      std::size_t k = 0;  // take() goes around the face from the same corner
      for (const auto v : copy.mesh.fv_range(f))
        for (const auto h : f.halfedges())
          if (h.to() == v) corners[k++] = static_cast<std::uint32_t>(copy.mesh.texcoord1D(h));
    }
  }
  Decimated out = copy.take({});
  refused_faces += out.refused_faces;
  return std::move(out.mesh);
}

}  // namespace whittle::recipe
