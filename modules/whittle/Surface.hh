/// \file
/// What a planner sees of a mesh: points, triangles, the faces around each vertex, and which vertices are
/// free.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "whittle/IndexedMesh.hh"
#include "whittle/errors.hh"

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

/// What else is known of a mesh; every part may be empty.
struct SurfaceExtras {
  std::vector<std::uint8_t> flags;  ///< for each vertex: kLocked, kFeature, kSeam
  /// For each vertex a factor of the planner's threshold: 0 keeps the vertex, 1 is neutral, 2 doubles the
  /// length or the angle. Finite, >= 0. Where a threshold concerns several vertices, the least factor counts.
  std::vector<float> tolerance;
  /// For each face the normal that the flip guard judges it by, of any length; its own where this is empty.
  std::vector<Eigen::Vector3d> reference_normals;
};

/// The faces of one vertex in order around it, as `RingWalk` finds them.
struct Ring {
  std::vector<std::uint32_t> faces;     ///< counter-clockwise
  std::vector<std::uint32_t> vertices;  ///< `vertices[i]`, `vertices[i + 1]` and the centre make `faces[i]`
  enum class Shape { closed, open, complex, empty } shape = Shape::empty;
};

/// A read-only view of an indexed mesh with the adjacency that planners need. The mesh must outlive it.
///
/// \tparam Real  precision of the points; all arithmetic on them is done in double.
template <typename Real>
class SurfaceT {
 public:
  using Triangle = typename IndexedMeshT<Real>::Triangle;

  /// \param mesh   every index must be in range.
  /// \throw InvalidMesh  an index out of range, a coordinate that is not finite.
  /// \throw InvalidParameter  extras of another size than the mesh, a tolerance that is negative or not
  /// finite.
  explicit SurfaceT(const IndexedMeshT<Real>& mesh, SurfaceExtras extras = {});

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

  /// The faces around `v` in index order, as a pair of pointers.
  std::pair<const std::uint32_t*, const std::uint32_t*> star(std::uint32_t v) const {
    return {faces_.data() + first_[v], faces_.data() + first_[v + 1]};
  }

  std::uint8_t flags(std::uint32_t v) const { return extras_.flags[v]; }
  bool is_free(std::uint32_t v, Boundary boundary = Boundary::keep) const {
    return flags(v) == 0 || (boundary == Boundary::merge && flags(v) == kBoundary);
  }
  /// Whether two vertices may become one; the link condition sees to it that it happens along the boundary.
  bool may_merge(std::uint32_t a, std::uint32_t b, Boundary boundary) const {
    return is_free(a, boundary) && is_free(b, boundary) && is_boundary(a) == is_boundary(b);
  }
  bool is_boundary(std::uint32_t v) const { return (flags(v) & kBoundary) != 0; }
  bool is_complex(std::uint32_t v) const { return (flags(v) & kComplex) != 0; }

 private:
  void collect_stars();

  const IndexedMeshT<Real>& mesh_;
  std::vector<std::uint32_t> first_, faces_;  // star of v: faces_[first_[v]] .. faces_[first_[v + 1]]
  SurfaceExtras extras_;
};

/// Orders the faces around vertices. Time is linear in the valence; keeps one scratch array for all vertices.
template <typename Real>
class RingWalk {
 public:
  explicit RingWalk(const SurfaceT<Real>& surface) : surface_(surface), slot_(surface.n_vertices(), 0) {}

  /// The ring of `v`; valid until the next call.
  const Ring& around(std::uint32_t v);

 private:
  struct Spoke {
    std::uint32_t face, next, previous;  // the corners after and before v in the face
    bool arrived;                        // another face arrives by the edge to `next`
  };
  static constexpr std::uint32_t kNone = 0xffffffffu;

  /// The spoke that begins at a neighbour. `slot_` is never cleared: a stale entry fails the comparison.
  std::uint32_t spoke_at(std::uint32_t neighbour) const {
    const std::uint32_t i = slot_[neighbour];
    return i < spokes_.size() && spokes_[i].next == neighbour ? i : kNone;
  }

  const SurfaceT<Real>& surface_;
  std::vector<std::uint32_t> slot_;
  std::vector<Spoke> spokes_;
  Ring ring_;
};

template <typename Real>
const Ring& RingWalk<Real>::around(std::uint32_t v) {
  ring_.faces.clear();
  ring_.vertices.clear();
  ring_.shape = Ring::Shape::empty;
  spokes_.clear();
  const auto [begin, end] = surface_.star(v);
  if (begin == end) return ring_;

  ring_.shape = Ring::Shape::complex;
  for (const std::uint32_t* f = begin; f != end; ++f) {
    const auto& t = surface_.triangle(*f);
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return ring_;
    const int i = t[0] == v ? 0 : t[1] == v ? 1 : 2;
    const std::uint32_t next = t[(i + 1) % 3];
    if (spoke_at(next) != kNone) return ring_;  // two faces leave by the same edge
    slot_[next] = static_cast<std::uint32_t>(spokes_.size());
    spokes_.push_back({*f, next, t[(i + 2) % 3], false});
  }

  // An open fan starts at the one neighbour that no face arrives at.
  std::uint32_t arrivals = 0;
  for (const Spoke& spoke : spokes_) {
    const std::uint32_t i = spoke_at(spoke.previous);
    if (i == kNone) continue;
    if (spokes_[i].arrived) return ring_;  // two faces arrive by the same edge
    spokes_[i].arrived = true;
    ++arrivals;
  }
  const std::uint32_t n = static_cast<std::uint32_t>(spokes_.size());
  if (arrivals + 1 < n) return ring_;  // more than one open fan
  const bool open = arrivals < n;
  std::uint32_t start = 0;
  while (open && spokes_[start].arrived) ++start;

  std::uint32_t at = start;
  do {
    ring_.faces.push_back(spokes_[at].face);
    ring_.vertices.push_back(spokes_[at].next);
    const std::uint32_t previous = spokes_[at].previous;
    at = spoke_at(previous);
    if (at == kNone) ring_.vertices.push_back(previous);
  } while (at != kNone && at != start);
  if (ring_.faces.size() == n) ring_.shape = open ? Ring::Shape::open : Ring::Shape::closed;
  return ring_;
}

template <typename Real>
SurfaceT<Real>::SurfaceT(const IndexedMeshT<Real>& mesh, SurfaceExtras extras)
    : mesh_(mesh), extras_(std::move(extras)) {
  const auto fits = [](std::size_t size, std::size_t wanted) { return size == 0 || size == wanted; };
  if (!fits(extras_.flags.size(), n_vertices()) || !fits(extras_.tolerance.size(), n_vertices()) ||
      !fits(extras_.reference_normals.size(), n_faces()))
    throw InvalidParameter("flags, tolerances or normals do not have the size of the mesh");
  extras_.flags.resize(mesh.points.size(), 0);
  for (std::uint32_t v = 0; v < n_vertices(); ++v) {
    if (!mesh.points[v].allFinite())
      throw InvalidMesh("vertex " + std::to_string(v) + " has a coordinate that is not finite");
    if (!(tolerance(v) >= 0 && std::isfinite(tolerance(v))))
      throw InvalidParameter("vertex " + std::to_string(v) +
                             " has a tolerance that is negative or not finite");
    if (tolerance(v) == 0) extras_.flags[v] |= kLocked;
  }
  collect_stars();

  RingWalk<Real> walk(*this);
  for (std::uint32_t v = 0; v < n_vertices(); ++v) switch (walk.around(v).shape) {
      case Ring::Shape::closed:
        break;
      case Ring::Shape::open:
        extras_.flags[v] |= kBoundary;
        break;
      case Ring::Shape::complex:
        extras_.flags[v] |= kComplex;
        break;
      case Ring::Shape::empty:
        extras_.flags[v] |= kIsolated;
        break;
    }
}

template <typename Real>
void SurfaceT<Real>::collect_stars() {
  first_.assign(mesh_.points.size() + 1, 0);
  for (const Triangle& t : mesh_.triangles)
    for (const std::uint32_t v : t) {
      if (v >= n_vertices())
        throw InvalidMesh("a triangle names vertex " + std::to_string(v) + " of " +
                          std::to_string(n_vertices()));
      ++first_[v + 1];
    }
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  faces_.resize(3 * mesh_.triangles.size());
  std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
  for (std::uint32_t f = 0; f < n_faces(); ++f)
    for (const std::uint32_t v : mesh_.triangles[f]) faces_[fill[v]++] = f;
}

}  // namespace whittle
