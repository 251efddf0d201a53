/// \file
/// What mq plans on: a mesh with a quadric at each vertex, edges that can be judged and collapsed.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/mq/Bound.hh"
#include "whittle/mq/CornerTable.hh"
#include "whittle/mq/MortonOrder.hh"
#include "whittle/mq/Ring.hh"
#include "whittle/mq/SymmetricMatrix.hh"
#include "whittle/mq/Values.hh"
#include "whittle/plan/CollapsePlan.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/threads.hh"

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
  using Part = std::uint16_t;
  static constexpr Part kEverywhere = 0;  ///< no part: of a face between parts, of a hand that works alone
  /// The part that one thread works in, and its notes.
  struct Hand {
    Part part = kEverywhere;
    std::uint32_t begin = 0, size = 0xffffffffu;  ///< its vertices
    std::uint32_t stamp = 0, stride = 1;  ///< the last mark that it has set; no other hand sets the same
    MemorylessQuadricRing ring = {};      ///< around the edge that was judged last
    MemorylessQuadricBound::Sorting sorting = {};  ///< of the same, where there is a bound
    bool has(std::uint32_t v) const { return v - begin < size; }
  };
  enum class Verdict { legal, illegal, elsewhere };  ///< elsewhere: the ring leaves the hand's part

  struct Options {
    float min_cos;                       ///< of the flip guard
    double feature_angle, max_distance;  ///< as MemorylessQuadric's
  };

  template <typename Real>
  MemorylessQuadricMesh(const IndexedMeshT<Real>& mesh, const SurfaceExtras& extras, const Options& options,
                        Crew& crew);

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
    if (all_free_) return true;
    const Hold a = holds_[table_.vertex(c)], b = holds_[table_.vertex(next(c))];
    return a + b <= kFixed;
  }
  using Placements = std::array<Placement, 4>;
  /// Four at once take hardly longer than one; some may be the same.
  Placements place(const std::array<Corner, 4>& corners) const;
  /// Whether an end's surroundings may have changed since the hand had that stamp.
  bool is_touched(Corner c, const Hand& hand, std::uint32_t since) const {
    const auto is_later = [&](std::uint32_t v) { return vertices_[v].mark - since - 1 < hand.stamp - since; };
    return is_later(table_.vertex(c)) || is_later(table_.vertex(next(c)));
  }
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
  using Vertex = MemorylessQuadricRing::Vertex;
  enum Hold : std::uint8_t { kFree, kFixed, kUntouchable };

  static constexpr double kPi = 3.14159265358979323846;

  const Vec& position(Corner c) const {
    return vertices_[table_.vertex(c)].position;
  }
  EIGEN_ALWAYS_INLINE Vec edge(Corner c) const {
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
    return static_cast<Part>((v * parts_per_vertex_ >> 32) + 1);
  }
  void cut();
  void sum_quadrics(Crew& crew);
  void add_faces(const std::array<Corner, 4>& faces, std::size_t n);
  void add_face(Corner f, SymmetricMatrix quadric);
  void set_values(const SurfaceExtras& extras);
  void mark_features(double angle);
  void set_weights(const std::vector<float>& tolerance);
  void set_bound(double distance, const std::vector<float>& tolerance);
  bool keeps_bound(Corner c, const Vec& target, Hand& hand) const;
  /// Four edges by their vertices, with the quadrics there.
  struct FourEdges {
    std::array<std::uint32_t, 4> start, end;
    std::array<const SymmetricMatrix*, 4> at_start, at_end;
  };
  Placements best_places(const FourEdges& edges) const;
  static Placement safe_place(const Vec& e, Hold a, Hold b, const SymmetricMatrix& at_a,
                              const SymmetricMatrix& at_b);

  /// Whether it is the end of the half-edge that survives: it is held, or it alone is on the boundary.
  bool keeps_end(Corner c) const {
    const std::uint32_t start = table_.vertex(c), end = table_.vertex(next(c));
    return holds_[end] == kFixed || (table_.is_open(end) && !table_.is_open(start));
  }
  template <typename Visit>
  bool survey(Corner c, Corner d, Hand& hand, Visit visit);
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
  bool all_free_ = true;  // all of them
  Part n_parts_ = 0;
  std::uint64_t parts_per_vertex_ = 1;       // times 2^32
  std::vector<std::uint32_t> first_vertex_;  // of each part, and where the last ends
  std::vector<std::size_t> first_face_;
  std::vector<float> weights_;  // of costs; empty where all are 1
  MemorylessQuadricValues values_;
  MemorylessQuadricBound bound_;
  bool has_features_ = false;
  bool has_lines_ = false;  // edges with planes of their own, boundary or feature
  float min_cos_;
  double scale_ = 1;
  Eigen::Vector3d center_;
};

inline auto MemorylessQuadricMesh::hand(Part part) const -> Hand {
  Hand hand;
  hand.part = part;
  hand.stamp = part;
  hand.stride = n_parts_ + 1u;
  if (part == kEverywhere) return hand;
  hand.begin = first_vertex_[part - 1u];
  hand.size = first_vertex_[part] - hand.begin;
  return hand;
}

inline void MemorylessQuadricMesh::set_part(Corner c) {
  const auto& t = table_.face(c).vertex;
  const Part part = part_of(t[0]);
  table_.face(c).part = part == part_of(t[1]) && part == part_of(t[2]) ? part : kEverywhere;
}

}  // namespace whittle
