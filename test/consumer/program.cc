/// \file
/// The program of the three projects beside it: a module of Whittle in a decimater and on a mesh type of their own.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <iostream>
#include <whittle/ModFaceAngleT.hh>

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Color);
  FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
  EdgeAttributes(OpenMesh::Attributes::Status);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

int main() {
  Mesh mesh;
  constexpr int n = 12;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) mesh.add_vertex({double(i), double(j), 0});
  for (int j = 0; j + 1 < n; ++j)
    for (int i = 0; i + 1 < n; ++i) {
      const auto v = [&](int di, int dj) { return Mesh::VertexHandle((j + dj) * n + i + di); };
      mesh.add_face(v(0, 0), v(1, 0), v(1, 1));
      mesh.add_face(v(0, 0), v(1, 1), v(0, 1));
    }
  mesh.update_normals();

  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  whittle::ModFaceAngleT<Mesh>::Handle fad;
  decimater.add(fad);
  decimater.module(fad).set_max_normal_angle(30);
  if (!decimater.initialize()) return 1;
  const std::size_t before = mesh.n_faces(), collapses = decimater.decimate();
  mesh.garbage_collection();
  std::cout << before << " faces, " << mesh.n_faces() << " after " << collapses << " collapses\n";
  return collapses > 0 && mesh.n_faces() == before - 2 * collapses ? 0 : 1;
}
