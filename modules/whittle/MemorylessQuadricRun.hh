/// \file
/// How mq plans: the queue, the placement, the guard, the collapse.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/BucketQueue.hh"
#include "whittle/CollapsePlan.hh"
#include "whittle/CornerTable.hh"
#include "whittle/IndexedMesh.hh"
#include "whittle/MortonOrder.hh"
#include "whittle/Surface.hh"
#include "whittle/SymmetricMatrix.hh"

namespace whittle {

/// The state of MemorylessQuadric while it plans.
class MemorylessQuadricRun {
 public:
  static constexpr std::uint8_t kHeld = kLocked | kFeature | kSeam;  ///< flags of vertices that stay in place

  template <typename Real>
  MemorylessQuadricRun(const IndexedMeshT<Real>& mesh, const SurfaceExtras& extras, float min_cos,
                       std::size_t n_threads);

  /// Collapses until at most so many faces or at most so many vertices are left.
  void run(std::size_t target_faces, std::size_t target_vertices);

  CollapsePlan take() { return std::move(plan_); }

 private:
  MemorylessQuadricRun(MortonOrder order, float min_cos, std::size_t n_threads);
  using Vec = Eigen::Vector3f;

  /// What every visit of a vertex needs; the rest lies apart, so that more of these stay in the cache.
  struct Vertex {
    Vec position;
    std::uint32_t mark;
  };
  enum Hold : std::uint8_t { kFree, kFixed, kUntouchable };
  /// A face around the edge that is judged, and the corner that moves.
  struct Turn {
    Corner corner;
    Vec before, after;
  };
  /// Where an edge's two ends merge, and what it costs.
  struct Placement {
    Vec offset;  ///< from the start of the half-edge
    float cost;
  };

  const Vec& position(Corner c) const { return vertices_[table_.vertex(c)].position; }
  Vec edge(Corner c) const { return position(next(c)) - position(c); }

  /// The planes along a boundary half-edge, upright on its face's plane or anywhere else: nine times the
  /// square of the distance from its line.
  static SymmetricMatrix boundary_quadric(const Vec& e) {
    return SymmetricMatrix::identity(9 * e.squaredNorm()) - SymmetricMatrix::outer(e, 9.0f);
  }
  static SymmetricMatrix face_quadric(const Vec& normal) {
    const float length = normal.norm();
    return length > 0 ? SymmetricMatrix::outer(normal, 1 / length) : SymmetricMatrix();
  }

  /// Faces may turn so much less than 90 degrees against their packed normal in the input.
  static constexpr float kUpright = 1e-4f;

  void sum_quadrics();
  void queue_all();
  void prefetch() const;
  void set_weights(const std::vector<float>& tolerance);
  Placement place(Corner c) const;
  Placement best_place(Corner c) const;
  bool is_movable(Corner c) const;

  /// Whether it is the end of the half-edge that survives: it is held, or it alone is on the boundary.
  bool keeps_end(Corner c) const {
    const std::uint32_t start = table_.vertex(c), end = table_.vertex(next(c));
    return holds_[end] == kFixed || (table_.is_open(end) && !table_.is_open(start));
  }
  bool is_legal(Corner c, const Vec& target);
  template <typename Visit>
  bool survey(std::uint32_t v, Corner c, const Vec& target, Visit visit);
  template <typename Visit>
  void for_each_boundary_edge(std::uint32_t v, Visit visit) const;
  Corner fuse(Corner c);
  void collapse(Corner c, const Placement& placement);
  void enqueue(Corner c, std::size_t bucket) {
    table_.face(c).queued |= 1u << (c & 3);
    queue_.push(c, bucket);
  }

  std::vector<std::uint32_t> input_;       // what each vertex is called in the input
  std::vector<std::uint32_t> input_face_;  // the same of each face, where its normal there is given
  CornerTable table_;
  std::vector<Vertex> vertices_;
  std::vector<SymmetricMatrix> quadrics_;
  std::vector<Hold> holds_;
  std::vector<float> weights_;  // of costs; empty where all are 1
  BucketQueue queue_;
  std::vector<Turn> turns_;
  std::size_t n_faces_, n_vertices_;
  std::uint32_t stamp_ = 0;
  float min_cos_;
  double scale_ = 1;
  Eigen::Vector3d center_;
  CollapsePlan plan_;
};

template <typename Real>
MemorylessQuadricRun::MemorylessQuadricRun(const IndexedMeshT<Real>& mesh, const SurfaceExtras& extras,
                                           float min_cos, std::size_t n_threads)
    : MemorylessQuadricRun(MortonOrder(mesh, !extras.reference_normals.empty()), min_cos, n_threads) {
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
  sum_quadrics();
  for (std::size_t f = 0; f < input_face_.size(); ++f) {
    const Eigen::Vector3d& normal = extras.reference_normals[input_face_[f]];
    table_.face(static_cast<Corner>(4 * f)).normal = PackedNormal(normal.stableNormalized().cast<float>());
  }
}

inline MemorylessQuadricRun::MemorylessQuadricRun(MortonOrder order, float min_cos, std::size_t n_threads)
    : input_(std::move(order.vertex)),
      input_face_(std::move(order.face)),
      vertices_(input_.size()),
      quadrics_(input_.size()),
      holds_(input_.size(), kFree),
      n_faces_(order.triangles.size()),
      n_vertices_(input_.size()),
      min_cos_(min_cos) {
  plan_.stages.push_back(0);
  const Rings rings(order.triangles, input_.size(), true, n_threads);
  table_ = CornerTable(order.triangles, rings, input_.size());
  for (std::uint32_t v = 0; v < input_.size(); ++v)
    if (rings.shape(v) == RingShape::complex) holds_[v] = kUntouchable;
}

inline void MemorylessQuadricRun::sum_quadrics() {
  for (Corner c = 0; c < 4 * table_.n_faces(); c += 4) {
    const Vec normal = edge(c).cross(-edge(c + 2));
    table_.face(c).normal = PackedNormal(normal);
    const SymmetricMatrix quadric = face_quadric(normal);
    for (Corner i = c; i < c + 3; ++i) {
      quadrics_[table_.vertex(i)] += quadric;
      if (table_.twin(i) != kNoCorner) continue;
      const SymmetricMatrix boundary = boundary_quadric(edge(i));
      quadrics_[table_.vertex(i)] += boundary;
      quadrics_[table_.vertex(next(i))] += boundary;
    }
  }
}

inline void MemorylessQuadricRun::set_weights(const std::vector<float>& tolerance) {
  constexpr float kLeast = 1e-4f;  // its weight is still far from the largest float
  weights_.resize(vertices_.size());
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const float least = std::max(kLeast, tolerance[input_[i]]);
    weights_[i] = 1 / (least * least);
  }
}

/// Both ends in a disc or a fan, and not both of them fixed.
inline bool MemorylessQuadricRun::is_movable(Corner c) const {
  const Hold a = holds_[table_.vertex(c)], b = holds_[table_.vertex(next(c))];
  return a + b <= kFixed;
}

inline void MemorylessQuadricRun::queue_all() {
  for (Corner f = 0; f < 4 * table_.n_faces(); f += 4)
    for (Corner c = f; c < f + 3; ++c)
      if ((table_.twin(c) == kNoCorner || c < table_.twin(c)) && is_movable(c))
        enqueue(c, BucketQueue::bucket_of(place(c).cost));
}

/// Minimises the sum of the squared distances to both ends' planes, u Ha u + (u - e) Hb (u - e), with a
/// slight pull to the middle that decides where the planes leave a direction open.
inline auto MemorylessQuadricRun::best_place(Corner c) const -> Placement {
  const std::uint32_t a = table_.vertex(c), b = table_.vertex(next(c));
  const SymmetricMatrix &at_a = quadrics_[a], &at_b = quadrics_[b];
  const Vec e = vertices_[b].position - vertices_[a].position;
  const Vec pull_b = at_b * e;
  if (holds_[a] == kFixed) return {Vec::Zero(), std::max(0.0f, e.dot(pull_b))};
  if (holds_[b] == kFixed) return {e, std::max(0.0f, e.dot(at_a * e))};
  const SymmetricMatrix sum = at_a + at_b;
  const float pull = 1e-5f * sum.trace();
  const Vec middle = e / 2;
  const Vec u = (sum + SymmetricMatrix::identity(pull)).solve(pull_b + pull * middle);
  if ((u - middle).squaredNorm() <= 4 * e.squaredNorm())
    return {u, std::max(0.0f, (e - u).dot(pull_b) - pull * u.dot(u - middle))};
  return {middle, std::max(0.0f, middle.dot(sum * middle))};
}

inline auto MemorylessQuadricRun::place(Corner c) const -> Placement {
  Placement placement = best_place(c);
  if (!weights_.empty())
    placement.cost *= std::max(weights_[table_.vertex(c)], weights_[table_.vertex(next(c))]);
  return placement;
}

/// Goes around `v`: shows its neighbours to `visit`, and collects the faces that stay when half-edge `c`
/// collapses to `target`. \return whether the guard allows what becomes of all of them.
template <typename Visit>
bool MemorylessQuadricRun::survey(std::uint32_t v, Corner c, const Vec& target, Visit visit) {
  const Corner d = table_.twin(c), first = table_.first(v);
  const float limit = min_cos_ * std::abs(min_cos_);
  Corner at = first, last = first;
  do {
    visit(vertices_[table_.vertex(next(at))]);
    if (at >> 2 != c >> 2 && (d == kNoCorner || at >> 2 != d >> 2)) {
      const Vec &p = position(at), &q = position(next(at)), &r = position(previous(at));
      const Turn turn{at, (q - p).cross(r - p), (q - target).cross(r - target)};
      const float before = turn.before.squaredNorm(), after = turn.after.squaredNorm();
      const float cosine = turn.before.dot(turn.after);
      if (before > 0 && !(cosine * std::abs(cosine) > limit * before * after)) return false;
      const PackedNormal input = table_.face(at).normal;
      const float overall = input.unpacked().dot(turn.after);
      if (!input.is_none() && !(overall > 0 && overall * overall > kUpright * after)) return false;
      turns_.push_back(turn);
    }
    last = at;
    at = table_.around(at);
  } while (at != kNoCorner && at != first);
  if (at == kNoCorner) visit(vertices_[table_.vertex(previous(last))]);
  return true;
}

/// The guard and the link condition: the ends have no neighbours in common but those opposite the edge.
inline bool MemorylessQuadricRun::is_legal(Corner c, const Vec& target) {
  const std::uint32_t a = table_.vertex(c), b = table_.vertex(next(c));
  const bool a_open = table_.is_open(a), b_open = table_.is_open(b), interior = table_.twin(c) != kNoCorner;
  if (interior && a_open && b_open) return false;  // the boundary would touch itself
  if ((a_open && !b_open && holds_[b] != kFree) || (b_open && !a_open && holds_[a] != kFree))
    return false;  // the boundary would leave its place

  ++stamp_;
  turns_.clear();
  std::size_t common = 0;
  if (!survey(a, c, target, [&](Vertex& v) { v.mark = stamp_; })) return false;
  const std::size_t of_a = turns_.size();
  if (!survey(b, c, target, [&](const Vertex& v) { common += v.mark == stamp_; })) return false;
  const std::size_t of_b = turns_.size() - of_a;
  if ((keeps_end(c) ? of_a : of_b) == 0) return false;  // the tip of an ear
  if (interior && !a_open && !b_open && of_a <= 1 && of_b <= 1)
    return false;  // two faces back to back would be left
  return common == (interior ? 2u : 1u);
}

/// Calls `visit(half-edge, neighbour)` for the two boundary edges at `v`, if there are.
template <typename Visit>
void MemorylessQuadricRun::for_each_boundary_edge(std::uint32_t v, Visit visit) const {
  if (!table_.is_open(v)) return;
  const Corner first = table_.first(v);
  visit(first, table_.vertex(next(first)));
  Corner last = first;
  for (Corner at = first; at != kNoCorner; at = table_.around(at)) last = at;
  visit(previous(last), table_.vertex(previous(last)));
}

/// The face of `c` is about to vanish and its two other edges are about to become one: sees to it that this
/// is queued once, if one of them is. \return a half-edge of it that has yet to be queued, or kNoCorner.
inline Corner MemorylessQuadricRun::fuse(Corner c) {
  const auto queued = [&](Corner at) {
    return at != kNoCorner && (table_.face(at).queued >> (at & 3) & 1) != 0;
  };
  const Corner left = table_.twin(next(c)), right = table_.twin(previous(c));
  if (queued(left) && queued(right)) table_.face(right).queued &= ~(1u << (right & 3));
  if (queued(left) || queued(right) || !(queued(next(c)) || queued(previous(c)))) return kNoCorner;
  return left != kNoCorner ? left : right;
}

inline void MemorylessQuadricRun::collapse(Corner c, const Placement& placement) {
  const std::uint32_t to = table_.vertex(c), from = table_.vertex(next(c));
  const Vec e = edge(c), target = position(c) + placement.offset;
  const std::array<Corner, 2> sides{c, table_.twin(c)};
  const std::uint32_t n_sides = sides[1] == kNoCorner ? 1 : 2;

  // What the vanishing faces and the boundary have added to the ring.
  for (std::uint32_t i = 0; i < n_sides; ++i) {
    const Corner tip = previous(sides[i]);
    quadrics_[table_.vertex(tip)] -= face_quadric(edge(sides[i]).cross(-edge(tip)));
  }
  for (const std::uint32_t v : {to, from})
    for_each_boundary_edge(
        v, [&](Corner half, std::uint32_t w) { quadrics_[w] -= boundary_quadric(edge(half)); });

  SymmetricMatrix quadric;
  for (const Turn& turn : turns_) {
    const SymmetricMatrix after = face_quadric(turn.after);
    quadric += after;
    const SymmetricMatrix change = after - face_quadric(turn.before);
    quadrics_[table_.vertex(next(turn.corner))] += change;
    quadrics_[table_.vertex(previous(turn.corner))] += change;
  }
  const bool swap = keeps_end(c);
  if (swap) std::swap(input_[from], input_[to]);  // the table merges the end into the start
  const float along = e.squaredNorm() > 0 ? placement.offset.dot(e) / e.squaredNorm() : 0.5f;
  ++plan_.record.planned;
  plan_.collapses.push_back({input_[from], input_[to], n_sides,
                             std::clamp(swap ? 1 - along : along, 0.0f, 1.0f),
                             center_ + scale_ * target.cast<double>()});

  std::array<Corner, 2> unqueued{kNoCorner, kNoCorner};
  for (std::uint32_t i = 0; i < n_sides; ++i) unqueued[i] = fuse(sides[i]);
  table_.collapse(c);
  n_faces_ -= n_sides;
  --n_vertices_;
  vertices_[to].position = target;
  if (holds_[from] == kFixed) holds_[to] = kFixed;
  if (!weights_.empty()) weights_[to] = std::max(weights_[to], weights_[from]);
  for_each_boundary_edge(to, [&](Corner half, std::uint32_t w) {
    const SymmetricMatrix boundary = boundary_quadric(edge(half));
    quadrics_[w] += boundary;
    quadric += boundary;
  });
  quadrics_[to] = quadric;
  for (const Corner at : unqueued)
    if (at != kNoCorner) enqueue(at, BucketQueue::bucket_of(place(at).cost));
}

/// Asks for the memory of the edges that come next.
inline void MemorylessQuadricRun::prefetch() const {
#if defined(__GNUC__)
  if (const std::uint32_t* later = queue_.peek(8)) __builtin_prefetch(&table_.face(*later));
  if (const std::uint32_t* soon = queue_.peek(3)) {
    const auto& face = table_.face(*soon);
    if (face.vertex[0] == CornerTable::kDead) return;
    for (const std::uint32_t v : face.vertex) {
      __builtin_prefetch(&vertices_[v]);
      __builtin_prefetch(&quadrics_[v]);
    }
  }
#endif
}

inline void MemorylessQuadricRun::run(std::size_t target_faces, std::size_t target_vertices) {
  queue_all();
  // How far there is to go: the faces, or twice the vertices, that must still vanish.
  const auto remaining = [&] {
    const auto over = [](std::size_t n, std::size_t target) { return n > target ? n - target : 0; };
    return std::min(over(n_faces_, target_faces), 2 * over(n_vertices_, target_vertices));
  };
  const auto all = static_cast<float>(remaining());
  Corner c = 0;
  while (remaining() > 0 && queue_.pop(c)) {
    prefetch();
    std::uint32_t& queued = table_.face(c).queued;
    const std::uint32_t bit = 1u << (c & 3);
    if (table_.is_dead(c) || !(queued & bit)) continue;
    queued &= ~bit;
    if (!is_movable(c)) continue;
    const Placement placement = place(c);
    const std::size_t bucket = BucketQueue::bucket_of(placement.cost);
    // Its surroundings may have changed since it was queued. Far from the target a little dearer is good
    // enough.
    constexpr float kOctaves = 2;
    const float tolerance = kOctaves * BucketQueue::kBucketsPerOctave * static_cast<float>(remaining()) / all;
    if (bucket > queue_.bucket() + static_cast<std::size_t>(tolerance))
      enqueue(c, bucket);
    else if (is_legal(c, position(c) + placement.offset))
      collapse(c, placement);
    else if (queue_.bucket() + 1 < BucketQueue::kBuckets)
      enqueue(c, queue_.bucket() + 4 * BucketQueue::kBucketsPerOctave);  // its surroundings may change yet
  }
}

}  // namespace whittle
