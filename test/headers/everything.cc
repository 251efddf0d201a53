/// \file
/// Every public header in one translation unit, and every class template of theirs with all of its members, on meshes
/// of single and double precision. Compiled with the warnings that a careful project turns on, and read by clang-tidy.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <whittle/DelaunayFlips.hh>
#include <whittle/LazyDecimaterT.hh>
#include <whittle/ModChainT.hh>
#include <whittle/ModCircumcenterT.hh>
#include <whittle/ModFaceAngleT.hh>
#include <whittle/ModFassT.hh>
#include <whittle/ModGuardedQuadricT.hh>
#include <whittle/ModMemorylessQuadricT.hh>
#include <whittle/ModSphereScanT.hh>
#include <whittle/ModVertexDistanceT.hh>
#include <whittle/ModVtdT.hh>
#include <whittle/SweepDecimaterT.hh>
#include <whittle/bulk.hh>
#include <whittle/compact.hh>
#include <whittle/decimate.hh>
#include <whittle/join_doubled.hh>
#include <whittle/openmesh/convert.hh>
#include <whittle/refit.hh>
#include <whittle/version.hh>

static_assert(WHITTLE_VERSION >= 200);

using FloatMesh = OpenMesh::TriMesh_ArrayKernelT<>;
using DoubleMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

template class whittle::ModChainT<FloatMesh, whittle::FaceAngle, whittle::SphereScan>;
template class whittle::ModCircumcenterT<FloatMesh>;
template class whittle::ModFaceAngleT<FloatMesh>;
template class whittle::ModFassT<FloatMesh>;
template class whittle::ModGuardedQuadricT<FloatMesh>;
template class whittle::ModMemorylessQuadricT<FloatMesh>;
template class whittle::ModSphereScanT<FloatMesh>;
template class whittle::ModVertexDistanceT<FloatMesh>;
template class whittle::ModVtdT<FloatMesh>;
template class whittle::SweepDecimaterT<FloatMesh>;
template class whittle::LazyDecimaterT<FloatMesh>;

template class whittle::ModChainT<DoubleMesh, whittle::FaceAngle, whittle::SphereScan>;
template class whittle::ModCircumcenterT<DoubleMesh>;
template class whittle::ModFaceAngleT<DoubleMesh>;
template class whittle::ModFassT<DoubleMesh>;
template class whittle::ModGuardedQuadricT<DoubleMesh>;
template class whittle::ModMemorylessQuadricT<DoubleMesh>;
template class whittle::ModSphereScanT<DoubleMesh>;
template class whittle::ModVertexDistanceT<DoubleMesh>;
template class whittle::ModVtdT<DoubleMesh>;
template class whittle::SweepDecimaterT<DoubleMesh>;
template class whittle::LazyDecimaterT<DoubleMesh>;

// The functions.
template <typename Mesh>
void every_function(Mesh& mesh) {
  using Real = typename Mesh::Scalar;
  const whittle::IndexedMeshT<Real> arrays = whittle::to_indexed(mesh);
  auto half = whittle::bulk(whittle::MemorylessQuadric(), arrays);
  whittle::refit(arrays, half);
  const auto folded = whittle::bulk(whittle::VertexDistance(), half.mesh);
  whittle::to_openmesh(folded.mesh, mesh);
  whittle::DecimateOptions options;
  options.ratio = 0.5;
  whittle::decimate(arrays, options);
  whittle::decimate(whittle::join_doubled(arrays).mesh, options);
  whittle::join_doubled(mesh);
  whittle::decimate(mesh, options);
  whittle::decimate(mesh, options, whittle::VertexDistance());
  whittle::delaunay_flips(mesh);
  whittle::compact(mesh);
}
template void every_function(FloatMesh&);
template void every_function(DoubleMesh&);
