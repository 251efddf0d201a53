/// \file
/// The edges of a part of the mesh in a queue, and the work on them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/mq/BucketQueue.hh"
#include "whittle/mq/Goal.hh"
#include "whittle/mq/InFours.hh"
#include "whittle/mq/Mesh.hh"
#include "whittle/mq/Worker.hh"
#include "whittle/mq/collapse.hh"
#include "whittle/mq/judge.hh"
#include "whittle/mq/place.hh"
#include "whittle/plan/CollapsePlan.hh"

namespace whittle::mq {

/// The edges whose faces are in a part. Parts work at the same time: each collapses an edge only if all that
/// this touches is its own, and leaves the others as strays. The one with kNoPart takes all edges, and works
/// alone.
class Part {
 public:
  struct Done {
    Collapse collapse;
    std::size_t bucket;
  };
  using Stray = BucketQueue::Entry;

  Part(Mesh& mesh, PartNumber number) : mesh_(mesh), worker_(mesh.partition, number) {}

  /// Queues the edges of some faces, or leaves them as strays.
  void queue_all(std::size_t first_face, std::size_t last_face);

  void push(const Stray& stray) { queue_.push(stray.item, stray.bucket); }

  /// Collapses what is in the queue below a bucket, until the goal is reached.
  void work(std::size_t end, Goal goal);

  const BucketQueue& queue() const { return queue_; }

  std::vector<Done> done;     ///< in order; the caller empties it
  std::vector<Stray> strays;  ///< edges that reach into other parts; the caller empties it
  PlanRecord refused;         ///< edges that stayed illegal to the end

 private:
  void enqueue(Corner c, std::size_t bucket) {
    mesh_.table.notes(c).set_queued(c);
    queue_.push(c, bucket);
  }
  bool is_queued(Corner c) const { return mesh_.table.notes(c).is_queued(c); }
  bool has(Corner c) const { return worker_.part == kNoPart || mesh_.table.notes(c).part == worker_.part; }
  std::size_t take_four(std::size_t end);
  void work(Corner c, const Placement& placement, std::size_t dearest, Goal& goal);
  void prefetch_next() const;

  Mesh& mesh_;
  Worker worker_;
  BucketQueue queue_;
  std::array<Corner, 4> four_ = {};  // the edges that are placed at once
  Placements placements_ = {};
};

inline void Part::queue_all(std::size_t first_face, std::size_t last_face) {
  std::vector<BucketQueue::Entry> own;
  own.reserve(3 * (last_face - first_face) / 2 + 1);
  const auto take = [&](const std::array<Corner, 4>& corners, std::size_t n) {
    const auto placements = place(mesh_, corners);
    for (std::size_t i = 0; i < n; ++i) {
      const auto bucket = static_cast<std::uint32_t>(BucketQueue::bucket_of(placements[i].cost));
      (has(corners[i]) ? own : strays).push_back({corners[i], bucket});
    }
  };
  InFours<Corner, decltype(take)> edges(take);
  for (std::size_t f = first_face; f < last_face; ++f)
    for (Corner c = corner_of(f); c < corner_of(f) + 3; ++c) {
      if (c > mesh_.table.twin(c) || !mesh_.is_movable(c)) continue;  // no corner is greater than kNoCorner
      mesh_.table.notes(c).set_queued(c);
      edges.add(c);
    }
  edges.flush();
  queue_.push_all(own);
}

/// Prefetches the memory of the edges that come next.
inline void Part::prefetch_next() const {
#if defined(__GNUC__)
  if (const std::uint32_t* later = queue_.peek(16)) __builtin_prefetch(&mesh_.table.face(*later));
  if (const std::uint32_t* soon = queue_.peek(6)) prefetch(mesh_, *soon, worker_);
#endif
}

/// Takes and places up to four edges of the cheapest bucket.
/// \return how many
inline std::size_t Part::take_four(std::size_t end) {
  std::size_t n = 0;
  Corner c = 0;
  while (n == 0) {
    if (!queue_.advance(end)) return 0;
    while (n < 4 && queue_.pop(c)) {
      prefetch_next();
      if (!has(c))
        strays.push_back({c, static_cast<std::uint32_t>(queue_.bucket())});
      else if (is_queued(c))
        four_[n++] = c;
    }
  }
  std::fill(four_.begin() + n, four_.end(), four_[0]);
  placements_ = place(mesh_, four_);
  return n;
}

inline void Part::work(std::size_t end, Goal goal) {
  // An edge's surroundings may have changed since it was queued. Far from the target an edge that has become
  // a little dearer is collapsed all the same.
  constexpr float kOctaves = 2;
  const float slack = kOctaves * BucketQueue::kBucketsPerOctave / static_cast<float>(goal.all);
  while (goal.remaining() > 0) {
    const std::size_t n = take_four(end);
    if (n == 0) return;
    const auto tolerance = static_cast<std::size_t>(slack * static_cast<float>(goal.remaining()));
    const std::size_t before = done.size();
    const std::uint32_t since = worker_.stamp;
    for (std::size_t i = 0; i < n; ++i) {
      const Corner c = four_[i];
      const bool is_fresh = done.size() == before;  // nothing has collapsed since they were placed
      if (!is_fresh && !is_queued(c)) continue;
      if (!is_fresh && (goal.remaining() == 0 || is_touched(mesh_, c, worker_, since)))
        queue_.push(c, queue_.bucket());
      else
        work(c, placements_[i], queue_.bucket() + tolerance, goal);
    }
  }
}

/// Collapses an edge, or puts it back.
inline void Part::work(Corner c, const Placement& placement, std::size_t dearest, Goal& goal) {
  FaceNotes& notes = mesh_.table.notes(c);
  notes.clear_queued(c);
  if (!mesh_.is_movable(c)) return;
  const std::size_t bucket = BucketQueue::bucket_of(placement.cost);
  if (bucket > dearest) return enqueue(c, bucket);
  constexpr std::size_t kLater = std::size_t{4} * BucketQueue::kBucketsPerOctave,
                        kLast = BucketQueue::kBuckets - 1;
  const bool may_drag = queue_.bucket() >= std::min(bucket + kLater, kLast);
  const Verdict verdict = judge(mesh_, c, placement, worker_, may_drag);
  if (verdict == Verdict::elsewhere) {
    notes.set_queued(c);
    strays.push_back({c, static_cast<std::uint32_t>(bucket)});
  } else if (verdict == Verdict::legal) {
    std::array<Corner, 2> unqueued;
    done.push_back({collapse(mesh_, c, placement, worker_, unqueued), queue_.bucket()});
    goal.count(done.back().collapse);
    for (const Corner at : unqueued)
      if (at != kNoCorner) enqueue(at, queue_.bucket());  // placed when it is taken
  } else if (queue_.bucket() < kLast) {
    enqueue(c, queue_.bucket() + kLater);  // it may become legal by then
  } else {
    refused.refused_by_link += verdict == Verdict::breaks_link;
    refused.refused_by_seam += verdict == Verdict::breaks_seam;
    refused.refused_by_flip_guard += verdict == Verdict::turns_face;
    refused.refused_by_bound += verdict == Verdict::breaks_bound;
  }
}

}  // namespace whittle::mq
