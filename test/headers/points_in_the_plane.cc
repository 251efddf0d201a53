/// \file
/// Must not compile: a mesh whose points have two coordinates.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <whittle/openmesh/convert.hh>

struct Plane : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec2f;
};

int main() {
  OpenMesh::TriMesh_ArrayKernelT<Plane> mesh;
  return static_cast<int>(whittle::to_indexed(mesh).points.size());
}
