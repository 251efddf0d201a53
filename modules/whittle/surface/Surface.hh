/// \file
/// What a planner sees of a mesh: points, triangles, one-rings, and which vertices are free.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Rings.hh"
#include "whittle/surface/SeamGraph.hh"
#include "whittle/surface/errors.hh"
#include "whittle/surface/seams.hh"
#include "whittle/surface/threads.hh"

namespace whittle {

/// Why a vertex must stay where it is. A vertex without any flag is *free*: it may move and vanish.
enum VertexFlag : std::uint8_t {
  kBoundary = 1,   ///< on an open edge; kept by default
  kComplex = 2,    ///< its faces are not one fan: non-manifold, or a face names it twice
  kLocked = 4,     ///< by the user
  kFeature = 8,    ///< by the user
  kIsolated = 16,  ///< in no face
  kSeam = 32       ///< its faces disagree about its texture coordinate
};

/// What a planner does with boundary vertices that nothing else holds.
enum class Boundary {
  keep,  ///< they stay
  merge  ///< they may merge with one another along the boundary, never with inner vertices
};

/// What a planner does with vertices on seams that nothing else holds. mq always merges them.
enum class Seams {
  keep,  ///< they stay
  merge  ///< those that a seam passes through may merge with one another along it, never with others; charts stay
};

/// The length, in model units, that a difference of 1 counts as beside the shape; 0: differences do not
/// count. Between normals a difference of 1 is 60 degrees, between colours black to full.
struct ValueWeights {
  double normals = 0, colours = 0, texture = 0;
  bool any() const { return normals > 0 || colours > 0 || texture > 0; }

  /// \throw InvalidParameter  a weight that is negative or not finite.
  void validate() const {
    for (const double weight : {normals, colours, texture})
      if (!(weight >= 0 && std::isfinite(weight)))
        throw InvalidParameter("the weight of a value must be a finite length of at least 0");
  }
};

/// What a planner may know beside the mesh; every member may be empty.
struct SurfaceExtras {
  static constexpr std::size_t kMostValues = 12;
  std::vector<std::uint8_t> flags;  ///< for each vertex: kLocked, kFeature, kSeam
  /// For each vertex a factor of the planner's threshold: 0 keeps the vertex, 1 is neutral, 2 doubles the
  /// length or the angle. Finite, >= 0. Where a threshold concerns several vertices, the least factor counts.
  std::vector<float> tolerance;
  /// For each face the normal that the flip guard judges it by, of any length; its own where this is empty.
  std::vector<Eigen::Vector3d> reference_normals;
  /// For each vertex `n_values` numbers that mq counts beside the shape: normals, colours, texture
  /// coordinates, each times the length, in model units, that a difference of 1 counts as. NaN: the vertex
  /// has no single value, as on a seam.
  std::vector<float> values = {};
  std::size_t n_values = 0;  ///< for each vertex, at most `kMostValues`
  /// For each face a number at each of its corners: corners of one vertex have the same number if they have
  /// the same texture coordinates, or whatever else is not to be torn. An edge of two faces is a *seam* if
  /// their numbers differ at either of its ends. mq moves vertices along seams; for other planners they have
  /// kSeam, and merge along seams if asked. Empty: no seams.
  std::vector<std::array<std::uint32_t, 3>> wedges = {};
};

namespace detail {

/// Checks what every planner relies on.
/// \return the extras with flags for every vertex; those of tolerance 0 are locked.
/// \throw InvalidMesh, InvalidParameter  as the constructor of SurfaceT.
template <typename Real>
SurfaceExtras checked(const IndexedMeshT<Real>& mesh, SurfaceExtras extras) {
  const std::size_t n_vertices = mesh.points.size(), n_faces = mesh.triangles.size();
  const auto fits = [](std::size_t size, std::size_t wanted) { return size == 0 || size == wanted; };
  if (!fits(extras.flags.size(), n_vertices) || !fits(extras.tolerance.size(), n_vertices) ||
      !fits(extras.reference_normals.size(), n_faces) || !fits(extras.wedges.size(), n_faces) ||
      extras.values.size() != extras.n_values * n_vertices)
    throw InvalidParameter(
        "flags, tolerances and values must be given for each vertex, or not at all; reference normals and "
        "wedges for each face");
  if (extras.n_values > SurfaceExtras::kMostValues)
    throw InvalidParameter("a vertex has more than " + std::to_string(SurfaceExtras::kMostValues) +
                           " values");
  if (n_faces > Fans::kMostTriangles)
    throw InvalidMesh("it has more than " + std::to_string(Fans::kMostTriangles) + " triangles");
  extras.flags.resize(n_vertices, 0);
  constexpr double kLargest = 1e100;  // its square is far from the largest double
  for (std::size_t v = 0; v < n_vertices; ++v) {
    if (!mesh.points[v].allFinite())
      throw InvalidMesh("vertex " + std::to_string(v) + " has a coordinate that is not finite");
    if (static_cast<double>(mesh.points[v].cwiseAbs().maxCoeff()) > kLargest)
      throw InvalidMesh("vertex " + std::to_string(v) +
                        " has a coordinate beyond 1e100, where areas overflow: scale the mesh down");
  }
  for (std::size_t v = 0; v < extras.tolerance.size(); ++v) {
    const float tolerance = extras.tolerance[v];
    if (!(tolerance >= 0 && std::isfinite(tolerance)))
      throw InvalidParameter("vertex " + std::to_string(v) +
                             " has a tolerance that is negative or not finite");
    if (tolerance == 0) extras.flags[v] |= kLocked;
  }
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t)
      if (v >= n_vertices)
        throw InvalidMesh("a triangle names vertex " + std::to_string(v) + " of " +
                          std::to_string(n_vertices));
  return extras;
}

template <typename Real>
Rings rings_of(const IndexedMeshT<Real>& mesh, bool with_faces, std::size_t n_threads) {
  constexpr std::size_t kLeast = 4096;  // vertices; for fewer a thread costs more than it saves
  Crew crew(std::min(n_threads, mesh.points.size() / kLeast));
  return {mesh.triangles, mesh.points.size(), with_faces, crew};
}

}  // namespace detail

/// A read-only view of an indexed mesh with the adjacency that planners need. The mesh must outlive it.
///
/// \tparam Real  precision of the points; all arithmetic on them is done in double.
template <typename Real>
class SurfaceT {
 public:
  using Triangle = typename IndexedMeshT<Real>::Triangle;

  /// \param mesh       every index must be in range.
  /// \param n_threads  for the build of the rings; the surface is the same for any number.
  /// \throw InvalidMesh  an index out of range, a coordinate that is not finite or beyond 1e100.
  /// \throw InvalidParameter  extras of another size than the mesh, a tolerance that is negative or not
  /// finite.
  explicit SurfaceT(const IndexedMeshT<Real>& mesh, SurfaceExtras extras = {}, std::size_t n_threads = 1);

  const IndexedMeshT<Real>& mesh() const { return mesh_; }
  const SurfaceExtras& extras() const { return extras_; }

  std::uint32_t n_vertices() const { return static_cast<std::uint32_t>(mesh_.points.size()); }
  std::uint32_t n_faces() const { return static_cast<std::uint32_t>(mesh_.triangles.size()); }

  Eigen::Vector3d point(std::uint32_t v) const { return mesh_.points[v].template cast<double>(); }
  const Triangle& triangle(std::uint32_t f) const { return mesh_.triangles[f]; }

  /// Cross product of two edges: twice the area long, zero for a degenerate face.
  Eigen::Vector3d normal(std::uint32_t f) const {
    const Triangle& t = triangle(f);
    const Eigen::Vector3d a = point(t[0]);
    return (point(t[1]) - a).cross(point(t[2]) - a);
  }

  /// The normal that the flip guard judges a face by.
  Eigen::Vector3d reference_normal(std::uint32_t f) const {
    return extras_.reference_normals.empty() ? normal(f) : extras_.reference_normals[f];
  }

  /// The factor of a planner's threshold at a vertex.
  double tolerance(std::uint32_t v) const {
    return extras_.tolerance.empty() ? 1 : double(extras_.tolerance[v]);
  }

  /// The neighbours of `v` in order; none where it is complex or isolated.
  Ring ring(std::uint32_t v) const { return rings_[v]; }

  /// The normal that the flip guard judges the i-th face of a ring by.
  bool has_reference_normals() const { return !extras_.reference_normals.empty(); }
  const Eigen::Vector3d& reference_normal(std::uint32_t v, std::size_t i) const {
    return extras_.reference_normals[rings_.face(v, i)];
  }

  std::uint8_t flags(std::uint32_t v) const { return extras_.flags[v]; }
  bool is_free(std::uint32_t v, Boundary boundary = Boundary::keep, Seams seams = Seams::keep) const {
    return flags(v) == 0 || (boundary == Boundary::merge && flags(v) == kBoundary) ||
           (seams == Seams::merge && flags(v) == kSeam && seams_.is_passed(v));
  }
  /// Whether two vertices may merge; boundary ones only along the boundary, which the link condition ensures, and
  /// those on seams only along a seam edge.
  bool may_merge(std::uint32_t a, std::uint32_t b, Boundary boundary, Seams seams = Seams::keep) const {
    return is_free(a, boundary, seams) && is_free(b, boundary, seams) && is_boundary(a) == is_boundary(b) &&
           is_on_seam(a) == is_on_seam(b) && (!is_on_seam(a) || seams_.may_remove(a, b));
  }
  bool is_boundary(std::uint32_t v) const { return (flags(v) & kBoundary) != 0; }
  bool is_on_seam(std::uint32_t v) const { return (flags(v) & kSeam) != 0; }
  /// How the seams run; empty where the extras have no wedges.
  const detail::SeamGraph& seams() const { return seams_; }
  bool is_complex(std::uint32_t v) const { return (flags(v) & kComplex) != 0; }

 private:
  const IndexedMeshT<Real>& mesh_;
  SurfaceExtras extras_;
  detail::Rings rings_;
  detail::SeamGraph seams_;
};

template <typename Real>
SurfaceT<Real>::SurfaceT(const IndexedMeshT<Real>& mesh, SurfaceExtras extras, std::size_t n_threads)
    : mesh_(mesh),
      extras_(detail::checked(mesh, std::move(extras))),
      rings_(detail::rings_of(mesh, has_reference_normals(), n_threads)) {
  using detail::RingShape;
  for (std::uint32_t v = 0; v < n_vertices(); ++v) switch (rings_.shape(v)) {
      case RingShape::closed:
        break;
      case RingShape::open:
        extras_.flags[v] |= kBoundary;
        break;
      case RingShape::complex:
        extras_.flags[v] |= kComplex;
        break;
      case RingShape::empty:
        extras_.flags[v] |= kIsolated;
        break;
    }
  if (extras_.wedges.empty()) return;
  const std::vector<bool> seams = on_seams(mesh.triangles, extras_.wedges, n_vertices());
  for (std::uint32_t v = 0; v < n_vertices(); ++v)
    if (seams[v]) extras_.flags[v] |= kSeam;
  seams_ = detail::SeamGraph(mesh.triangles, extras_.wedges, n_vertices());
}

}  // namespace whittle
