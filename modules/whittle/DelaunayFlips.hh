/// \file
/// Delaunay retriangulation by edge flips, after a decimation or on its own.
#pragma once

#include <Eigen/Geometry>
#include <OpenMesh/Core/Mesh/Handles.hh>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <string>
#include <vector>

#include "whittle/openmesh/find_halfedge.hh"
#include "whittle/plan/FlipGuard.hh"
#include "whittle/surface/constants.hh"
#include "whittle/surface/errors.hh"

namespace whittle {

/// What `delaunay_flips` may do. Vertices never move.
///
/// An edge is flipped where the two angles opposite to it sum to more than 180 degrees (Paper 1, the last
/// step of every algorithm), if nothing below forbids it.
struct DelaunayFlips {
  static constexpr std::size_t kEightPerEdge = ~std::size_t{0};
  /// Degrees, in [0, 180]: the largest angle between the normals of an edge's two faces at which the edge may
  /// flip; 180 is no bound. A flip over a sharper edge would cut a ridge or bridge a valley.
  double max_dihedral = 20;
  /// Against the two faces that a flip replaces: each new normal to each old one.
  FlipGuard guard;
  /// The run stops after so many. On a curved surface nothing proves that flips come to an end.
  std::size_t max_flips = kEightPerEdge;

  /// \throw InvalidParameter  a value outside the range given above.
  void validate() const {
    if (!(max_dihedral >= 0 && max_dihedral <= 180))
      throw InvalidParameter("DelaunayFlips: the dihedral angle must be between 0 and 180 degrees");
    guard.validate();
  }
};

/// What came of it. An edge that is left although its angles sum to more than 180 degrees counts once, with
/// the reason that held when it was last looked at.
struct DelaunayFlipsReport {
  std::size_t flipped = 0;              ///< flips; an edge may flip more than once
  std::size_t kept = 0;                 ///< locked, feature or seam edges left as they are
  std::size_t refused_by_guard = 0;     ///< by `max_dihedral`, the flip guard, or for a degenerate new face
  std::size_t refused_by_topology = 0;  ///< the new edge would be there already
  bool converged = true;                ///< false: `max_flips` was reached, and more edges would flip
};

/// One run of `delaunay_flips`. The half-edge h of an edge, its opposite o, and what lies around them:
///
///          c                  c          before: the faces a b c, of h, h1, h2, and b a d, of o, o1, o2
///      h2/   \h1            / | \        after:  the faces a d c, of h, h2, o1, and b c d, of o, o2, h1;
///       a --- b     ->     a  |  b               h points to c, o to d
///      o1\   /o2            \ | /
///          d                  d
template <typename Mesh>
class DelaunayFlipperT {
 public:
  DelaunayFlipperT(Mesh& mesh, const DelaunayFlips& options, const std::vector<bool>& region);
  DelaunayFlipsReport run();

 private:
  using EdgeHandle = typename Mesh::EdgeHandle;
  using FaceHandle = typename Mesh::FaceHandle;
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;
  using VertexHandle = typename Mesh::VertexHandle;
  enum class Verdict : std::uint8_t { stays, flips, kept, refused_by_guard, refused_by_topology };
  using Vector = Eigen::Vector3d;

  /// With less, two angles count as 180 degrees together. Beside two right angles it is 0.00006 degrees.
  static constexpr double kMinCotSum = 1e-6;
  /// A face whose area is twice below this share of its longest edge squared has no normal: where points are
  /// floats, it would be the normal of the rounding.
  static constexpr double kDegenerate =
      std::max(1e-10, 8 * double(std::numeric_limits<typename Mesh::Scalar>::epsilon()));
  /// Half-edge normals are sums in different orders, so they are equal only nearly; about 0.06 degrees.
  static constexpr double kSameNormal = 1e-3;

  struct Quad {
    HalfedgeHandle h, o, h1, h2, o1, o2;
    VertexHandle a, b, c, d;
    Quad(const Mesh& m, EdgeHandle e)
        : h(m.halfedge_handle(e, 0)),
          o(m.halfedge_handle(e, 1)),
          h1(m.next_halfedge_handle(h)),
          h2(m.next_halfedge_handle(h1)),
          o1(m.next_halfedge_handle(o)),
          o2(m.next_halfedge_handle(o1)),
          a(m.to_vertex_handle(o)),
          b(m.to_vertex_handle(h)),
          c(m.to_vertex_handle(h1)),
          d(m.to_vertex_handle(o1)) {}
  };

  void check() const;
  Verdict judge(EdgeHandle e) const;
  Verdict judge_shape(const Quad& q) const;
  void flip(EdgeHandle e);

  /// Whether the edge is locked, a feature or a seam.
  bool is_bound(EdgeHandle e, const Quad& q) const;
  bool corners_agree(HalfedgeHandle l, HalfedgeHandle r) const;
  void copy_corner(HalfedgeHandle from, HalfedgeHandle to);

  void push(EdgeHandle e) {
    if (!queued_[index(e)]) queue_.push_back(e);
    queued_[index(e)] = true;
  }
  Verdict& verdict(EdgeHandle e) { return verdict_[index(e)]; }
  bool in_region(VertexHandle v) const { return region_.empty() || region_[index(v)]; }
  static std::size_t index(OpenMesh::BaseHandle h) { return static_cast<std::size_t>(h.idx()); }
  template <typename P>
  static Vector vector(const P& p) {
    return {double(p[0]), double(p[1]), double(p[2])};
  }
  Vector point(VertexHandle v) const { return vector(mesh_.point(v)); }

  /// Zero where the face is degenerate.
  static Vector unit_normal(const Vector& p, const Vector& q, const Vector& r) {
    const Vector n = (q - p).cross(r - p);
    const double longest = std::max({(q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm()});
    const double length = n.norm();
    return length > kDegenerate * longest ? Vector(n / length) : Vector(Vector::Zero());
  }

  Mesh& mesh_;
  const DelaunayFlips& options_;
  const std::vector<bool>& region_;
  double min_dihedral_cos_;
  std::vector<Verdict> verdict_;  // of each edge, when it was last looked at
  std::deque<EdgeHandle> queue_;
  std::vector<bool> queued_;
};

/// Flips edges until every edge that may flip is locally Delaunay: the angles opposite to it sum to at most
/// 180 degrees. All edges are looked at in index order, and those around a flip once more; the same mesh
/// gives the same result on every run.
///
/// Left as they are: edges of one face; locked and feature edges (edge status); seams, that is edges whose
/// faces disagree about half-edge texture coordinates, normals or colours at one of its ends, or about the
/// face's colour or texture index. A flipped edge keeps its handle, status and colour; its two half-edges get
/// the texture coordinates, normals and colours of their new corners. The normals of its faces, where the
/// mesh has any, are computed anew; vertex normals and properties of the user's own stay as they are. Deleted
/// elements are skipped, so the mesh may come from a decimater, without garbage collection.
///
/// \param region  for each vertex whether its neighbourhood may change: only edges with one of their ends or
///                opposite vertices in it are looked at. Empty: all.
/// \pre the points have three coordinates.
/// \throw InvalidParameter  an option outside its range, or a region of another size than the mesh's.
/// \throw InvalidMesh  a face is not a triangle, or a coordinate is not finite. The mesh is as it was.
template <typename Mesh>
DelaunayFlipsReport delaunay_flips(Mesh& mesh, const DelaunayFlips& options = {},
                                   const std::vector<bool>& region = {}) {
  static_assert(Mesh::is_trimesh(), "only triangles have edges to flip");
  options.validate();
  if (!region.empty() && region.size() != mesh.n_vertices())
    throw InvalidParameter("delaunay_flips: the region must have an entry for each vertex");
  return DelaunayFlipperT<Mesh>(mesh, options, region).run();
}

template <typename Mesh>
DelaunayFlipperT<Mesh>::DelaunayFlipperT(Mesh& mesh, const DelaunayFlips& options,
                                         const std::vector<bool>& region)
    : mesh_(mesh),
      options_(options),
      region_(region),
      // Rounding may take the cosine of two equal unit normals a few ulps below 1, hence the allowance.
      min_dihedral_cos_(std::cos(options.max_dihedral * (detail::kPi / 180)) - 1e-12),
      verdict_(mesh.n_edges(), Verdict::stays),
      queued_(mesh.n_edges(), false) {}

template <typename Mesh>
DelaunayFlipsReport DelaunayFlipperT<Mesh>::run() {
  check();
  DelaunayFlipsReport report;
  const std::size_t eight = 8 * mesh_.n_edges(),
                    most = options_.max_flips == DelaunayFlips::kEightPerEdge ? eight : options_.max_flips;
  for (const EdgeHandle e : mesh_.all_edges()) push(e);
  std::size_t before;
  do {
    before = report.flipped;
    while (!queue_.empty()) {
      const EdgeHandle e = queue_.front();
      queue_.pop_front();
      queued_[index(e)] = false;
      verdict(e) = judge(e);
      if (verdict(e) != Verdict::flips) continue;
      report.converged = report.flipped < most;
      if (!report.converged) break;
      flip(e);
      ++report.flipped;
    }
    // The edge that was in the way of these may have been flipped since.
    for (const EdgeHandle e : mesh_.all_edges())
      if (verdict(e) == Verdict::refused_by_topology) push(e);
  } while (report.converged && report.flipped > before);
  const auto count = [&](Verdict v) { return std::size_t(std::count(verdict_.begin(), verdict_.end(), v)); };
  report.kept = count(Verdict::kept);
  report.refused_by_guard = count(Verdict::refused_by_guard);
  report.refused_by_topology = count(Verdict::refused_by_topology);
  return report;
}

template <typename Mesh>
void DelaunayFlipperT<Mesh>::check() const {
  for (const FaceHandle f : mesh_.all_faces()) {
    if (mesh_.has_face_status() && mesh_.status(f).deleted()) continue;
    HalfedgeHandle h = mesh_.halfedge_handle(f);
    for (int corner = 0; corner < 3; ++corner, h = mesh_.next_halfedge_handle(h))
      if (!point(mesh_.to_vertex_handle(h)).allFinite())
        throw InvalidMesh("a coordinate of face " + std::to_string(f.idx()) + " is not finite");
    if (h != mesh_.halfedge_handle(f))
      throw InvalidMesh("face " + std::to_string(f.idx()) + " is not a triangle");
  }
}

template <typename Mesh>
auto DelaunayFlipperT<Mesh>::judge(EdgeHandle e) const -> Verdict {
  if ((mesh_.has_edge_status() && mesh_.status(e).deleted()) || mesh_.is_boundary(e)) return Verdict::stays;
  const Quad q(mesh_, e);
  if (!(in_region(q.a) || in_region(q.b) || in_region(q.c) || in_region(q.d))) return Verdict::stays;

  // The angles sum to more than 180 degrees where their cotangents sum to less than 0. The cotangent of 180
  // degrees is minus infinity; that of no angle at all, for two points in one place, is NaN: the edge stays.
  const Vector a = point(q.a), b = point(q.b);
  const auto cot = [&](const Vector& p) { return (a - p).dot(b - p) / (a - p).cross(b - p).norm(); };
  if (!(cot(point(q.c)) + cot(point(q.d)) < -kMinCotSum)) return Verdict::stays;

  if (is_bound(e, q)) return Verdict::kept;
  const Verdict shape = judge_shape(q);
  if (shape != Verdict::flips) return shape;
  // An inner vertex of three edges is safe too: the two vertices opposite to such an edge are connected.
  return q.c != q.d && !detail::find_halfedge(mesh_, q.c, q.d).is_valid() ? Verdict::flips
                                                                          : Verdict::refused_by_topology;
}

template <typename Mesh>
auto DelaunayFlipperT<Mesh>::judge_shape(const Quad& q) const -> Verdict {
  const Vector a = point(q.a), b = point(q.b), c = point(q.c), d = point(q.d);
  const std::array<Vector, 2> before{unit_normal(a, b, c), unit_normal(b, a, d)},
      after{unit_normal(a, d, c), unit_normal(b, c, d)};
  if (after[0].isZero(0) || after[1].isZero(0)) return Verdict::refused_by_guard;
  // A face without area has no normal to keep, and is best flipped away.
  if (!before[0].isZero(0) && !before[1].isZero(0) && !(before[0].dot(before[1]) >= min_dihedral_cos_))
    return Verdict::refused_by_guard;
  if (options_.guard.min_cos <= -1) return Verdict::flips;
  for (const Vector& was : before)
    for (const Vector& is : after)
      if (!was.isZero(0) && !(was.dot(is) > options_.guard.min_cos)) return Verdict::refused_by_guard;
  return Verdict::flips;
}

template <typename Mesh>
bool DelaunayFlipperT<Mesh>::is_bound(EdgeHandle e, const Quad& q) const {
  if (mesh_.has_edge_status() && (mesh_.status(e).locked() || mesh_.status(e).feature())) return true;
  const FaceHandle l = mesh_.face_handle(q.h), r = mesh_.face_handle(q.o);
  if (mesh_.has_face_colors() && !(mesh_.color(l) == mesh_.color(r))) return true;
  if (mesh_.has_face_texture_index() && mesh_.texture_index(l) != mesh_.texture_index(r)) return true;
  return !corners_agree(q.h, q.o2) || !corners_agree(q.h2, q.o);
}

/// A half-edge carries what its face has at the vertex that it points to.
template <typename Mesh>
bool DelaunayFlipperT<Mesh>::corners_agree(HalfedgeHandle l, HalfedgeHandle r) const {
  const Mesh& m = mesh_;
  return !(
      (m.has_halfedge_texcoords1D() && !(m.texcoord1D(l) == m.texcoord1D(r))) ||
      (m.has_halfedge_texcoords2D() && !(m.texcoord2D(l) == m.texcoord2D(r))) ||
      (m.has_halfedge_texcoords3D() && !(m.texcoord3D(l) == m.texcoord3D(r))) ||
      (m.has_halfedge_colors() && !(m.color(l) == m.color(r))) ||
      (m.has_halfedge_normals() && !((vector(m.normal(l)) - vector(m.normal(r))).norm() <= kSameNormal)));
}

template <typename Mesh>
void DelaunayFlipperT<Mesh>::copy_corner(HalfedgeHandle from, HalfedgeHandle to) {
  if (mesh_.has_halfedge_texcoords1D()) mesh_.set_texcoord1D(to, mesh_.texcoord1D(from));
  if (mesh_.has_halfedge_texcoords2D()) mesh_.set_texcoord2D(to, mesh_.texcoord2D(from));
  if (mesh_.has_halfedge_texcoords3D()) mesh_.set_texcoord3D(to, mesh_.texcoord3D(from));
  if (mesh_.has_halfedge_colors()) mesh_.set_color(to, mesh_.color(from));
  if (mesh_.has_halfedge_normals()) mesh_.set_normal(to, mesh_.normal(from));
}

template <typename Mesh>
void DelaunayFlipperT<Mesh>::flip(EdgeHandle e) {
  const Quad q(mesh_, e);
  mesh_.flip(e);
  // The four half-edges around point where they did; OpenMesh leaves what h and o carried for b and a.
  copy_corner(q.h1, q.h);
  copy_corner(q.o1, q.o);
  if (mesh_.has_face_normals())
    for (const HalfedgeHandle h : {q.h, q.o}) mesh_.update_normal(mesh_.face_handle(h));
  for (const HalfedgeHandle h : {q.h1, q.h2, q.o1, q.o2}) push(mesh_.edge_handle(h));
}

}  // namespace whittle
