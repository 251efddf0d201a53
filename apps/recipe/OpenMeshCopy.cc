#include "recipe/OpenMeshCopy.hh"

#include <numeric>

#include "whittle/openmesh/FaceAdderT.hh"

namespace whittle::recipe {

OpenMeshCopy::OpenMeshCopy(const IndexedMesh& in) {
  for (const auto& p : in.points) mesh.add_vertex(Mesh::Point(p[0], p[1], p[2]));
  detail::FaceAdderT<Mesh> faces(mesh);
  for (std::uint32_t f = 0; f < in.triangles.size(); ++f) {
    const auto corner = [&](std::size_t i) {
      return Mesh::VertexHandle(static_cast<int>(in.triangles[f][i]));
    };
    if (faces.add({corner(0), corner(1), corner(2)}).is_valid())
      face_origin_.push_back(f);
    else
      ++refused_faces_;
  }
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_halfedge_status();
  mesh.request_face_status();
  mesh.request_face_normals();  // the stock normal modules complain where they are missing
  mesh.update_face_normals();
}

void OpenMeshCopy::set_wedges(const IndexedMesh& in, const std::vector<IndexedMesh::Triangle>& wedges) {
  mesh.request_halfedge_texcoords1D();
  for (const auto f : mesh.faces())
    for (const auto h : f.halfedges()) {
      const std::uint32_t old = origin(f);
      for (std::size_t k = 0; k < 3; ++k)
        if (in.triangles[old][k] == static_cast<std::uint32_t>(h.to().idx()))
          mesh.set_texcoord1D(h, wedges[old][k]);
    }
}

Decimated OpenMeshCopy::take(const std::vector<std::pair<int, int>>& collapses) const {
  std::vector<std::uint32_t> survivor(mesh.n_vertices());
  std::iota(survivor.begin(), survivor.end(), 0u);
  for (auto c = collapses.rbegin(); c != collapses.rend(); ++c) survivor[c->first] = survivor[c->second];

  Decimated out;
  out.refused_faces = refused_faces_;
  out.vertex_map.resize(mesh.n_vertices());
  for (const auto v : mesh.all_vertices()) {
    if (mesh.status(v).deleted()) continue;
    out.vertex_map[v.idx()] = static_cast<std::uint32_t>(out.mesh.points.size());
    const auto& p = mesh.point(v);
    out.mesh.points.emplace_back(p[0], p[1], p[2]);
  }
  for (std::size_t v = 0; v < survivor.size(); ++v) out.vertex_map[v] = out.vertex_map[survivor[v]];
  for (const auto f : mesh.all_faces()) {
    if (mesh.status(f).deleted()) continue;
    IndexedMesh::Triangle t{};
    int i = 0;
    for (const auto v : mesh.fv_range(f)) t[i++] = out.vertex_map[v.idx()];
    out.mesh.triangles.push_back(t);
    out.face_origin.push_back(origin(f));
  }
  return out;
}

}  // namespace whittle::recipe
