/// \file
/// Test meshes as OpenMesh meshes.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>  // ModNormalFlippingT uses it without including it
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "catch.hh"
#include "meshes.hh"
#include "whittle/openmesh/convert.hh"
#include "whittle/plan/execute.hh"

namespace fixture {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;

/// An observer that calls a halt after so many collapses, looking every `interval`.
struct StopAfter : OpenMesh::Decimater::Observer {
  explicit StopAfter(std::size_t n, std::size_t interval = 1) : Observer(interval), limit(n) {}
  void notify(std::size_t n) override { seen = n; }
  bool abort() const override { return seen >= limit; }
  std::size_t limit, seen = 0;
};

template <typename M, typename Real>
M to_openmesh(const whittle::IndexedMeshT<Real>& in) {
  M mesh;
  for (const auto& p : in.points) {
    typename M::Point q;
    for (int i = 0; i < 3; ++i) q[i] = static_cast<typename M::Scalar>(p[i]);
    mesh.add_vertex(q);
  }
  const auto handle = [](std::uint32_t v) { return typename M::VertexHandle(static_cast<int>(v)); };
  for (const auto& t : in.triangles)
    REQUIRE(mesh.add_face(handle(t[0]), handle(t[1]), handle(t[2])).is_valid());
  return mesh;
}

/// Runs one module, set up by `setup`, in a decimater of type D on a copy of the mesh; what is alive
/// afterwards.
template <template <typename> class D, template <typename> class Module, typename M, typename Setup>
whittle::IndexedMeshT<typename M::Scalar> run(M mesh, Setup setup, std::size_t* collapses = nullptr) {
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  D<M> decimater(mesh);
  typename Module<M>::Handle handle;
  decimater.add(handle);
  setup(decimater.module(handle));
  REQUIRE(decimater.initialize());
  const std::size_t done = decimater.decimate();
  if (collapses) *collapses = done;
  return whittle::to_indexed(mesh);
}

}  // namespace fixture
