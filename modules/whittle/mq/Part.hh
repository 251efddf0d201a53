/// \file
/// A part of the mesh that mq plans on, with the queue of its edges.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/mq/BucketQueue.hh"
#include "whittle/mq/Collapse.hh"
#include "whittle/mq/Mesh.hh"
#include "whittle/plan/CollapsePlan.hh"

namespace whittle {

/// How far there is to go.
struct MemorylessQuadricGoal {
  std::size_t faces = 0, vertices = 0;  ///< that must still vanish; the goal is reached when one is 0
  std::size_t all = 1;                  ///< what `remaining` was at the start

  std::size_t remaining() const { return std::min(faces, 2 * vertices); }  ///< in faces
  void count(const Collapse& collapse) {
    faces -= std::min<std::size_t>(faces, collapse.faces);
    vertices -= vertices > 0;
  }
};

/// The edges in the faces of a part. Parts work at the same time: one judges an edge only if
/// all that the collapse would touch is its own, and leaves the others as strays. That of everything takes
/// all edges, but works alone.
class MemorylessQuadricPart {
 public:
  struct Done {
    Collapse collapse;
    std::size_t bucket;
  };
  using Stray = BucketQueue::Entry;

  MemorylessQuadricPart(MemorylessQuadricMesh& mesh, MemorylessQuadricMesh::Part number)
      : mesh_(mesh), hand_(mesh.hand(number)) {}

  /// Queues the edges of some faces, or leaves them as strays.
  void queue_all(std::size_t first_face, std::size_t last_face);

  void push(const Stray& stray) { queue_.push(stray.item, stray.bucket); }

  /// Collapses what is in the queue below a bucket, until the goal is reached.
  void work(std::size_t end, MemorylessQuadricGoal goal);

  const BucketQueue& queue() const { return queue_; }
  std::vector<Done> done;  ///< in order; the caller empties it
  std::vector<Stray> strays;

 private:
  void enqueue(Corner c, std::size_t bucket) {
    mesh_.table().face(c).queued |= bit_of(c);
    queue_.push(c, bucket);
  }
  static std::uint16_t bit_of(Corner c) { return static_cast<std::uint16_t>(1u << (c & 3)); }
  static bool is_queued(const CornerTable& table, Corner c) {
    return (table.face(c).queued & bit_of(c)) != 0;
  }
  bool has(Corner c) const {
    return hand_.part == MemorylessQuadricMesh::kEverywhere || mesh_.table().face(c).part == hand_.part;
  }
  std::size_t take_four(std::size_t end);
  void work(Corner c, const MemorylessQuadricMesh::Placement& placement, std::size_t dearest,
            MemorylessQuadricGoal& goal);
  void prefetch() const;

  MemorylessQuadricMesh& mesh_;
  MemorylessQuadricMesh::Hand hand_;
  BucketQueue queue_;
  std::array<Corner, 4> four_ = {};  // whose turn it is
  MemorylessQuadricMesh::Placements placements_ = {};
};

inline void MemorylessQuadricPart::queue_all(std::size_t first_face, std::size_t last_face) {
  CornerTable& table = mesh_.table();
  std::vector<BucketQueue::Entry> own;
  own.reserve(3 * (last_face - first_face) / 2 + 1);
  const auto take = [&](const std::array<Corner, 4>& corners, std::size_t n) {
    const auto placements = mesh_.place(corners);
    for (std::size_t i = 0; i < n; ++i) {
      const auto bucket = static_cast<std::uint32_t>(BucketQueue::bucket_of(placements[i].cost));
      (has(corners[i]) ? own : strays).push_back({corners[i], bucket});
    }
  };
  InFours<Corner, decltype(take)> edges(take);
  for (std::size_t f = first_face; f < last_face; ++f)
    for (Corner c = corner_of(f); c < corner_of(f) + 3; ++c) {
      if (c > table.twin(c) || !mesh_.is_movable(c)) continue;  // no corner is greater than kNoCorner
      table.face(c).queued |= bit_of(c);
      edges.add(c);
    }
  edges.flush();
  queue_.push_all(own);
}

/// Asks for the memory of the edges that come next.
inline void MemorylessQuadricPart::prefetch() const {
#if defined(__GNUC__)
  if (const std::uint32_t* later = queue_.peek(16)) __builtin_prefetch(&mesh_.table().face(*later));
  if (const std::uint32_t* soon = queue_.peek(6)) mesh_.prefetch(*soon, hand_);
#endif
}

/// Takes up to four edges of the next bucket that has any. \return  how many
inline std::size_t MemorylessQuadricPart::take_four(std::size_t end) {
  const CornerTable& table = mesh_.table();
  std::size_t n = 0;
  Corner c = 0;
  while (n == 0) {
    if (!queue_.advance(end)) return 0;
    while (n < 4 && queue_.pop(c)) {
      prefetch();
      if (!has(c))
        strays.push_back({c, static_cast<std::uint32_t>(queue_.bucket())});
      else if (is_queued(table, c))
        four_[n++] = c;
    }
  }
  std::fill(four_.begin() + n, four_.end(), four_[0]);
  placements_ = mesh_.place(four_);
  return n;
}

inline void MemorylessQuadricPart::work(std::size_t end, MemorylessQuadricGoal goal) {
  const CornerTable& table = mesh_.table();
  // An edge's surroundings may have changed since it was queued. Far from the target a little dearer is good
  // enough.
  constexpr float kOctaves = 2;
  const float slack = kOctaves * BucketQueue::kBucketsPerOctave / static_cast<float>(goal.all);
  while (goal.remaining() > 0) {
    const std::size_t n = take_four(end);
    if (n == 0) return;
    const auto tolerance = static_cast<std::size_t>(slack * static_cast<float>(goal.remaining()));
    const std::size_t before = done.size();
    const std::uint32_t since = hand_.stamp;
    for (std::size_t i = 0; i < n; ++i) {
      const Corner c = four_[i];
      const bool is_fresh = done.size() == before;  // nothing has happened since they were placed
      if (!is_fresh && !is_queued(table, c)) continue;
      if (!is_fresh && (goal.remaining() == 0 || mesh_.is_touched(c, hand_, since)))
        queue_.push(c, queue_.bucket());
      else
        work(c, placements_[i], queue_.bucket() + tolerance, goal);
    }
  }
}

/// Collapses an edge, or puts it back.
inline void MemorylessQuadricPart::work(Corner c, const MemorylessQuadricMesh::Placement& placement,
                                        std::size_t dearest, MemorylessQuadricGoal& goal) {
  std::uint16_t& queued = mesh_.table().face(c).queued;
  queued &= static_cast<std::uint16_t>(~bit_of(c));
  if (!mesh_.is_movable(c)) return;
  const std::size_t bucket = BucketQueue::bucket_of(placement.cost);
  if (bucket > dearest) return enqueue(c, bucket);
  const auto verdict = mesh_.judge(c, placement, hand_);
  if (verdict == MemorylessQuadricMesh::Verdict::elsewhere) {
    queued |= bit_of(c);
    strays.push_back({c, static_cast<std::uint32_t>(bucket)});
  } else if (verdict == MemorylessQuadricMesh::Verdict::legal) {
    std::array<Corner, 2> unqueued;
    done.push_back({mesh_.collapse(c, placement, hand_, unqueued), queue_.bucket()});
    goal.count(done.back().collapse);
    for (const Corner at : unqueued)
      if (at != kNoCorner) enqueue(at, queue_.bucket());  // to be placed when its turn comes
  } else if (queue_.bucket() + 1 < BucketQueue::kBuckets) {
    enqueue(c, queue_.bucket() + 4 * BucketQueue::kBucketsPerOctave);  // its surroundings may change yet
  }
}

}  // namespace whittle
