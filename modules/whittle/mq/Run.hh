/// \file
/// The whole of mq: parts that work at the same time, step by step.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "whittle/mq/BucketQueue.hh"
#include "whittle/mq/Goal.hh"
#include "whittle/mq/Mesh.hh"
#include "whittle/mq/Part.hh"
#include "whittle/mq/build.hh"
#include "whittle/plan/CollapsePlan.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/threads.hh"

namespace whittle::mq {

/// Plans down to a number of faces or vertices.
///
/// The mesh is cut into parts, as many for any number of threads. In a step each part collapses the edges
/// below a bucket whose surroundings are all its own; then, alone, `across_` collapses those across the parts;
/// then the bucket rises. The order within a step makes no difference between parts, so the plan lists it by
/// cost.
class Run {
 public:
  template <typename Real>
  Run(const IndexedMeshT<Real>& mesh, const SurfaceExtras& extras, const Options& options,
      std::size_t n_threads)
      : crew_(n_threads),
        mesh_(build(mesh, extras, options, crew_)),
        across_(mesh_, kNoPart),
        n_faces_(mesh.triangles.size()),
        n_vertices_(mesh.points.size()) {
    plan_.stages.push_back(0);
    queue_all();
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// Collapses until at most so many faces or at most so many vertices are left.
  /// \param costs  takes what each collapse has cost, to a quarter of an octave; lengths count in units of `scale`
  void run(std::size_t target_faces, std::size_t target_vertices, std::vector<float>* costs = nullptr);

  double scale() const { return mesh_.scale; }  ///< in model units

  CollapsePlan take() { return std::move(plan_); }

 private:
  void queue_all();
  void gather_strays();
  void append(std::size_t begin, std::size_t end);
  void append(const Part::Done& done);
  std::size_t next_bucket() const;
  std::size_t n_queued(std::size_t bucket) const;
  std::size_t step_end(std::size_t begin) const;

  detail::Crew crew_;
  Mesh mesh_;
  std::vector<Part> parts_;
  Part across_;
  std::size_t n_faces_, n_vertices_;
  Goal goal_;
  double faces_per_edge_ = 2;  // that vanished in the last step, for each edge that was queued for it
  CollapsePlan plan_;
  std::vector<float>* costs_ = nullptr;
};

/// Makes the parts and queues all edges.
inline void Run::queue_all() {
  const PartNumber n = mesh_.partition.size();
  if (n < 2) return across_.queue_all(0, n_faces_);
  for (unsigned i = 1; i <= n; ++i) parts_.emplace_back(mesh_, static_cast<PartNumber>(i));
  crew_.each(n, [&](std::size_t i) {
    parts_[i].queue_all(mesh_.partition.first_face(i + 1), mesh_.partition.first_face(i + 2));
  });
  gather_strays();
}

inline void Run::gather_strays() {
  for (Part& part : parts_) {
    for (const auto& stray : part.strays) across_.push(stray);
    part.strays.clear();
  }
}

inline void Run::append(const Part::Done& done) {
  plan_.collapses.push_back(done.collapse);
  goal_.count(done.collapse);
  if (costs_) costs_->push_back(BucketQueue::cost_of(done.bucket));
}

/// Puts into the plan what the parts have done in a step, bucket by bucket, until the goal is reached.
inline void Run::append(std::size_t begin, std::size_t end) {
  std::vector<std::size_t> read(parts_.size(), 0);
  for (std::size_t bucket = begin; bucket < end; ++bucket)
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const auto& done = parts_[i].done;
      for (; read[i] < done.size() && done[read[i]].bucket == bucket && goal_.remaining() > 0; ++read[i])
        append(done[read[i]]);
    }
  for (Part& part : parts_) part.done.clear();
}

inline std::size_t Run::next_bucket() const {
  std::size_t least = across_.queue().next_bucket();
  for (const Part& part : parts_) least = std::min(least, part.queue().next_bucket());
  return least;
}

inline std::size_t Run::n_queued(std::size_t bucket) const {
  std::size_t n = across_.queue().size(bucket);
  for (const Part& part : parts_) n += part.queue().size(bucket);
  return n;
}

/// The wider a step, the more a part does before the cache has to hold another one; but at its end much of
/// the way must be left, or the parts would reach the target alone, with the edges between them left out.
inline std::size_t Run::step_end(std::size_t begin) const {
  constexpr std::size_t kWidest = 16;
  constexpr double kMost = 0.75;
  double faces = 0;
  std::size_t end = begin;
  while (end < begin + kWidest && end < BucketQueue::kBuckets) {
    faces += faces_per_edge_ * static_cast<double>(n_queued(end));
    if (end > begin && faces > kMost * static_cast<double>(goal_.remaining())) break;
    ++end;
  }
  return end;
}

inline void Run::run(std::size_t target_faces, std::size_t target_vertices, std::vector<float>* costs) {
  costs_ = costs;
  const auto over = [](std::size_t n, std::size_t target) { return n > target ? n - target : 0; };
  goal_.faces = over(n_faces_, target_faces);
  goal_.vertices = over(n_vertices_, target_vertices);
  goal_.all = goal_.remaining();
  constexpr std::size_t kFew = 400;  // edges that are done before another thread has begun
  plan_.collapses.reserve(goal_.remaining() / 2 + goal_.remaining() / 64 + 1);  // some take one face only
  while (goal_.remaining() > 0) {
    const std::size_t begin = next_bucket();
    if (begin == BucketQueue::kBuckets) break;
    const std::size_t end = step_end(begin);
    std::size_t queued = 0;
    for (std::size_t bucket = begin; bucket < end; ++bucket) queued += n_queued(bucket);
    const std::size_t remaining = goal_.remaining();
    const auto work = [&](std::size_t i) { parts_[i].work(end, goal_); };
    if (queued < kFew)
      for (std::size_t i = 0; i < parts_.size(); ++i) work(i);
    else
      crew_.each(parts_.size(), work);
    gather_strays();
    append(begin, end);
    across_.work(end, goal_);
    for (const auto& done : across_.done) append(done);
    across_.done.clear();
    faces_per_edge_ =
        std::max(0.125, static_cast<double>(remaining - goal_.remaining()) / static_cast<double>(queued));
  }
  plan_.record = across_.refused;
  for (const Part& part : parts_) plan_.record += part.refused;
  plan_.record.planned = plan_.collapses.size();
}

}  // namespace whittle::mq
