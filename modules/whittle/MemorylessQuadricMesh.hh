/// \file
/// What mq plans on: a mesh with a quadric at each vertex, edges that can be judged and collapsed.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/CollapsePlan.hh"
#include "whittle/CornerTable.hh"
#include "whittle/Crew.hh"
#include "whittle/IndexedMesh.hh"
#include "whittle/MemorylessQuadricValues.hh"
#include "whittle/MortonOrder.hh"
#include "whittle/Surface.hh"
#include "whittle/SymmetricMatrix.hh"

namespace whittle {

/// A copy of unit size in floats, renumbered along a Morton curve.
///
/// Several threads may judge and collapse at once. The vertices fall into parts by their numbers, and a face
/// into the part of its vertices if all three are in the same. What a Hand judges or collapses in its part
/// touches nothing but that part's vertices and faces; what it asks of others is only which part a face is
/// in, and that changes when nothing else is done.
class MemorylessQuadricMesh {
 public:
  static constexpr std::uint8_t kHeld = kLocked | kFeature | kSeam;  ///< flags of vertices that stay in place
  using Vec = Eigen::Vector3f;

  /// Where an edge's two ends merge, and what it costs.
  struct Placement {
    Vec offset;  ///< from the start of the half-edge
    float cost;
  };
  /// A face around the edge that is judged, and the corner that moves.
  struct Turn {
    Corner corner;
    Vec before, after;  ///< its normal, twice its area long
  };
  using Part = std::uint16_t;
  static constexpr Part kEverywhere = 0;  ///< no part: of a face between parts, of a hand that works alone
  /// The part that one thread works in, and its notes.
  struct Hand {
    Part part = kEverywhere;
    std::uint32_t begin = 0, size = 0xffffffffu;  ///< its vertices
    std::uint32_t stamp = 0, stride = 1;  ///< the last mark that it has set; no other hand sets the same
    std::vector<Turn> turns = {};         ///< of the edge that was judged last
    bool has(std::uint32_t v) const { return v - begin < size; }
  };
  enum class Verdict { legal, illegal, elsewhere };  ///< elsewhere: the ring leaves the hand's part

  /// \param feature_angle  between the normals of two faces, radians: sharper edges are held as the boundary
  /// is
  template <typename Real>
  MemorylessQuadricMesh(const IndexedMeshT<Real>& mesh, const SurfaceExtras& extras, float min_cos,
                        double feature_angle, Crew& crew);

  CornerTable& table() { return table_; }
  const CornerTable& table() const { return table_; }

  Part n_parts() const { return n_parts_; }
  /// A hand for a part, counted from 1, or for kEverywhere.
  Hand hand(Part part) const;
  /// Where the faces begin that have their smallest vertex in a part; of the part after the last, where they
  /// end.
  std::size_t first_face(std::size_t part) const { return first_face_[part - 1]; }

  /// Both ends in a disc or a fan, and not both of them fixed.
  bool is_movable(Corner c) const {
    const Hold a = holds_[table_.vertex(c)], b = holds_[table_.vertex(next(c))];
    return a + b <= kFixed;
  }
  Placement place(Corner c) const;
  /// The guard and the link condition: the ends have no neighbours in common but those opposite the edge.
  Verdict judge(Corner c, const Placement& placement, Hand& hand);
  /// Collapses the edge that the hand has just judged.
  /// \param unqueued  half-edges of two queued edges that have become one, which is not queued; or kNoCorner
  Collapse collapse(Corner c, const Placement& placement, const Hand& hand, std::array<Corner, 2>& unqueued);

  /// Asks for the memory that `place` will read.
  void prefetch(Corner c, const Hand& hand) const {
#if defined(__GNUC__)
    const auto& face = table_.face(c);
    if (hand.part != kEverywhere && hand.part != face.part) return;
    if (face.vertex[0] == CornerTable::kDead) return;
    for (const std::uint32_t v : face.vertex) {
      __builtin_prefetch(&vertices_[v]);
      __builtin_prefetch(&quadrics_[v]);
    }
#endif
  }

 private:
  MemorylessQuadricMesh(MortonOrder order, float min_cos, Crew& crew);

  /// What every visit of a vertex needs; the rest lies apart, so that more of these stay in the cache.
  struct Vertex {
    Vec position;
    std::uint32_t mark;
  };
  enum Hold : std::uint8_t { kFree, kFixed, kUntouchable };

  static constexpr double kPi = 3.14159265358979323846;
  /// Faces may turn so much less than 90 degrees against their packed normal in the input.
  static constexpr float kUpright = 1e-4f;

  const Vec& position(Corner c) const {
    return vertices_[table_.vertex(c)].position;
  }
  Vec edge(Corner c) const {
    return position(next(c)) - position(c);
  }

  /// The planes along a boundary or feature half-edge, upright on its face's plane or anywhere else: nine
  /// times the square of the distance from its line.
  static SymmetricMatrix boundary_quadric(const Vec& e) {
    return SymmetricMatrix::identity(9 * e.squaredNorm()) - SymmetricMatrix::outer(e, 9.0f);
  }
  static SymmetricMatrix face_quadric(const Vec& normal) {
    const float length = normal.norm();
    return length > 0 ? SymmetricMatrix::outer(normal, 1 / length) : SymmetricMatrix();
  }

  Part part_of(std::uint32_t v) const {
    return static_cast<Part>(v / part_size_ + 1);
  }
  void find_first_faces();
  void sum_quadrics(Crew& crew);
  void add_face(Corner f);
  void set_values(const SurfaceExtras& extras);
  void mark_features(double angle);
  void set_weights(const std::vector<float>& tolerance);
  Placement best_place(Corner c) const;

  /// Whether it is the end of the half-edge that survives: it is held, or it alone is on the boundary.
  bool keeps_end(Corner c) const {
    const std::uint32_t start = table_.vertex(c), end = table_.vertex(next(c));
    return holds_[end] == kFixed || (table_.is_open(end) && !table_.is_open(start));
  }
  template <typename Visit>
  Verdict survey(std::uint32_t v, Corner c, const Vec& target, Hand& hand, Visit visit);
  template <typename Visit>
  void for_each_line(std::uint32_t v, Visit visit) const;
  void update_ring(Corner c, const Hand& hand, SymmetricMatrix& own);
  void update_values(Corner c, const Vec& target, float along, const Hand& hand, SymmetricMatrix& own);
  Corner fuse(Corner c);
  void set_part(Corner c);

  std::vector<std::uint32_t> input_;       // what each vertex is called in the input
  std::vector<std::uint32_t> input_face_;  // the same of each face, where its normal there is given
  CornerTable table_;
  std::vector<Vertex> vertices_;
  std::vector<SymmetricMatrix> quadrics_;
  std::vector<Hold> holds_;
  std::uint32_t part_size_ = 1;  // in vertices; the last part may be smaller
  Part n_parts_ = 0;
  std::vector<std::size_t> first_face_;
  std::vector<float> weights_;  // of costs; empty where all are 1
  MemorylessQuadricValues values_;
  bool has_features_ = false;
  float min_cos_;
  double scale_ = 1;
  Eigen::Vector3d center_;
};

template <typename Real>
MemorylessQuadricMesh::MemorylessQuadricMesh(const IndexedMeshT<Real>& mesh, const SurfaceExtras& extras,
                                             float min_cos, double feature_angle, Crew& crew)
    : MemorylessQuadricMesh(MortonOrder(mesh, !extras.reference_normals.empty()), min_cos, crew) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(HUGE_VAL), high = -low;
  for (const auto& p : mesh.points) {
    low = low.cwiseMin(p.template cast<double>());
    high = high.cwiseMax(p.template cast<double>());
  }
  center_ = (low + high) / 2;
  if ((high - low).maxCoeff() > 0) scale_ = (high - low).maxCoeff();
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const std::uint32_t v = input_[i];
    const Eigen::Vector3d p = mesh.points[v].template cast<double>();
    vertices_[i] = {((p - center_) / scale_).template cast<float>(), 0};
    if (holds_[i] == kFree && !extras.flags.empty() && (extras.flags[v] & kHeld)) holds_[i] = kFixed;
  }
  if (!extras.tolerance.empty()) set_weights(extras.tolerance);
  if (extras.n_values > 0) set_values(extras);
  sum_quadrics(crew);
  if (feature_angle < kPi) mark_features(feature_angle);
  for (std::size_t f = 0; f < input_face_.size(); ++f) {
    const Vec normal = extras.reference_normals[input_face_[f]].stableNormalized().cast<float>();
    table_.face(static_cast<Corner>(4 * f)).normal =
        normal.squaredNorm() > 0 ? PackedNormal(normal) : PackedNormal();
  }
}

inline MemorylessQuadricMesh::MemorylessQuadricMesh(MortonOrder order, float min_cos, Crew& crew)
    : input_(std::move(order.vertex)),
      input_face_(std::move(order.face)),
      vertices_(input_.size()),
      quadrics_(input_.size()),
      holds_(input_.size(), kFree),
      min_cos_(min_cos) {
  const Rings rings(order.triangles, input_.size(), true, crew.size());
  table_ = CornerTable(order.triangles, rings, input_.size(), crew.size());
  for (std::uint32_t v = 0; v < input_.size(); ++v)
    if (rings.shape(v) == RingShape::complex) holds_[v] = kUntouchable;
  // Larger parts leave less between them, smaller ones fit the cache; four keep several threads busy.
  constexpr std::size_t kPartSize = 16384, kLeastSize = 4096, kSome = 4;
  const std::size_t n = input_.size(), some = std::clamp<std::size_t>(n / kLeastSize, 1, kSome);
  const std::size_t n_parts = std::clamp<std::size_t>(n / kPartSize, some, 0xffff);
  part_size_ = static_cast<std::uint32_t>(std::max<std::size_t>(1, (n + n_parts - 1) / n_parts));
  n_parts_ = static_cast<Part>(n_parts);
  find_first_faces();
}

inline auto MemorylessQuadricMesh::hand(Part part) const -> Hand {
  Hand hand;
  hand.part = part;
  hand.stamp = part;
  hand.stride = n_parts_ + 1u;
  if (part == kEverywhere) return hand;
  hand.begin = (part - 1u) * part_size_;
  hand.size = part_size_;
  return hand;
}

/// Faces come in the order of their smallest vertex.
inline void MemorylessQuadricMesh::find_first_faces() {
  first_face_.assign(n_parts() + 1u, table_.n_faces());
  for (std::size_t f = table_.n_faces(); f-- > 0;) {
    const auto& t = table_.face(static_cast<Corner>(4 * f)).vertex;
    first_face_[part_of(std::min({t[0], t[1], t[2]})) - 1u] = f;
  }
  for (std::size_t i = n_parts(); i-- > 0;) first_face_[i] = std::min(first_face_[i], first_face_[i + 1]);
}

/// Each part by itself, then what lies between them: the same sums for any number of threads.
inline void MemorylessQuadricMesh::sum_quadrics(Crew& crew) {
  std::vector<std::vector<Corner>> between(n_parts());
  crew.each(n_parts(), [&](std::size_t i) {
    for (std::size_t f = first_face_[i]; f < first_face_[i + 1]; ++f) {
      const auto c = static_cast<Corner>(4 * f);
      set_part(c);
      if (table_.face(c).part == kEverywhere)
        between[i].push_back(c);
      else
        add_face(c);
    }
  });
  for (const std::vector<Corner>& faces : between)
    for (const Corner c : faces) add_face(c);
}

inline void MemorylessQuadricMesh::add_face(Corner f) {
  const Vec normal = edge(f).cross(-edge(f + 2));
  const float length = normal.norm();
  SymmetricMatrix quadric;
  if (length > 0) {
    const Vec unit = normal * (1 / length);
    table_.face(f).normal = PackedNormal(unit);
    quadric = SymmetricMatrix::outer(unit, length);
  }
  if (!values_.empty()) {
    const auto& [a, b, c] = table_.face(f).vertex;
    const auto term = values_.term(position(f), position(f + 1), position(f + 2), values_.at(a),
                                   values_.at(b), values_.at(c));
    quadric += term.form;
    for (const std::uint32_t v : table_.face(f).vertex) values_.add(v, term, 1);
  }
  for (Corner c = f; c < f + 3; ++c) {
    quadrics_[table_.vertex(c)] += quadric;
    if (table_.twin(c) != kNoCorner) continue;
    const SymmetricMatrix boundary = boundary_quadric(edge(c));
    quadrics_[table_.vertex(c)] += boundary;
    quadrics_[table_.vertex(next(c))] += boundary;
  }
}

inline void MemorylessQuadricMesh::set_values(const SurfaceExtras& extras) {
  const std::size_t n = extras.n_values;
  std::vector<float> values(n * vertices_.size());
  for (std::size_t i = 0; i < vertices_.size(); ++i)
    for (std::size_t k = 0; k < n; ++k)
      values[n * i + k] = static_cast<float>(static_cast<double>(extras.values[n * input_[i] + k]) / scale_);
  values_ = MemorylessQuadricValues(std::move(values), n);
}

/// Edges between two faces that meet at more than an angle become lines.
inline void MemorylessQuadricMesh::mark_features(double angle) {
  const auto normal = [&](Corner c) { return edge(c).cross(-edge(previous(c))).normalized().eval(); };
  const auto least = static_cast<float>(std::cos(angle));
  for (Corner f = 0; f < 4 * table_.n_faces(); f += 4)
    for (Corner c = f; c < f + 3; ++c) {
      const Corner d = table_.twin(c);
      if (d == kNoCorner || d < c || !(normal(c).dot(normal(d)) < least)) continue;
      table_.set_line(c);
      table_.set_line(d);
      has_features_ = true;
      for (const std::uint32_t v : {table_.vertex(c), table_.vertex(d)})
        quadrics_[v] += boundary_quadric(edge(c));
    }
}

inline void MemorylessQuadricMesh::set_weights(const std::vector<float>& tolerance) {
  constexpr float kLeast = 1e-4f;  // its weight is still far from the largest float
  weights_.resize(vertices_.size());
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const float least = std::max(kLeast, tolerance[input_[i]]);
    weights_[i] = 1 / (least * least);
  }
}

inline void MemorylessQuadricMesh::set_part(Corner c) {
  const auto& t = table_.face(c).vertex;
  const Part part = part_of(t[0]);
  table_.face(c).part = part == part_of(t[1]) && part == part_of(t[2]) ? part : kEverywhere;
}

}  // namespace whittle
