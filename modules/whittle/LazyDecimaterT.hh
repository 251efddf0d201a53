/// \file
/// A decimater for any set of modules that tests a collapse only when its turn comes.
#pragma once

#include <algorithm>
#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

#include "whittle/openmesh/DriverT.hh"
#include "whittle/openmesh/EarlyPriorityT.hh"

namespace whittle {

/// Use it in place of OpenMesh's DecimaterT. That one tests the legality of every collapse around every
/// vertex that a collapse touches, and most of these collapses never come up. This one asks the modules for
/// priorities first, and tests legality when a collapse is the best of all. After a collapse the vertices
/// around the survivor are marked; a marked vertex is judged anew when it comes up. So a vertex whose
/// priority has improved may come up late, which makes the order differ a little from DecimaterT's, and with
/// it the mesh; with planned modules it does not. Of equal priorities the one judged first comes first, so that on a plane
/// the collapses spread over it and no vertex gathers all edges; at the start they go by vertex index. A vertex with more than 64
/// edges is judged anew when an eighth of them has changed, and at the end.
template <typename MeshT>
class LazyDecimaterT : public DriverT<MeshT> {
 public:
  using Driver = DriverT<MeshT>;
  using Mesh = MeshT;
  using CollapseInfo = typename Driver::CollapseInfo;
  using VertexHandle = typename Driver::VertexHandle;
  using HalfedgeHandle = typename Driver::HalfedgeHandle;

  explicit LazyDecimaterT(Mesh& mesh) : Driver(mesh) {}

 protected:
  void run(bool only_selected) override;

 private:
  struct Entry {
    float priority;
    int vertex;
    std::uint32_t version;
    std::uint32_t turn;
    bool operator<(const Entry& other) const {  // std::priority_queue has the largest on top
      return priority != other.priority ? priority > other.priority : turn > other.turn;
    }
  };
  struct Candidate {
    HalfedgeHandle collapse;    ///< the best one that removes this vertex
    std::uint32_t version = 0;  ///< queue entries of an older version are void
    bool queued = false;
    bool marked = false;        ///< its neighbourhood has changed since it was judged
    std::uint32_t edges = 0;    ///< that it was judged by
    std::uint32_t changes = 0;  ///< around it since
  };

  struct Choice {
    HalfedgeHandle collapse;
    float least;  ///< that its priority can be; negative: it is not allowed
  };
  static constexpr std::uint32_t kMany = 64;  ///< edges, of which a vertex with more is a hub

  /// The collapses that remove `v`; of a hub, those that can have the least priorities come first.
  const std::vector<Choice>& choices(VertexHandle v);
  /// Judges the collapses that remove `v`, legal or not unless `only_legal`, and queues the best.
  void judge(VertexHandle v, bool only_legal);

  /// Whether a vertex has very many edges, and too few have changed for judging all of them anew.
  static bool is_hub_at_rest(const Candidate& candidate) {
    constexpr std::uint32_t kShare = 8;
    return candidate.edges > kMany && candidate.changes < candidate.edges / kShare;
  }
  /// Judges one collapse of a hub that has none in the queue, and queues it if it is allowed.
  void judge_one(HalfedgeHandle h);
  /// Judges a hub by the collapse that was its best; where that is gone, all of them, or later.
  void judge_hub(VertexHandle v);
  void enqueue(VertexHandle v, float priority, std::uint32_t version) {
    queue_.push({priority, v.idx(), version, turn_++});
  }
  void put_off(VertexHandle v) {
    candidates_[static_cast<std::size_t>(v.idx())].queued = false;
    waiting_.push_back(v);
  }
  /// Judges those that were put off.
  void judge_waiting();

  std::vector<Candidate> candidates_;
  std::vector<VertexHandle> waiting_;
  std::priority_queue<Entry> queue_;
  std::uint32_t turn_ = 0;  ///< of the next entry
  std::vector<Choice> choices_;
  EarlyPriorityT<Mesh>* early_ = nullptr;
};

template <typename MeshT>
auto LazyDecimaterT<MeshT>::choices(VertexHandle v) -> const std::vector<Choice>& {
  choices_.clear();
  for (auto h = this->mesh_.cvoh_iter(v); h.is_valid(); ++h)
    choices_.push_back({*h, early_ ? early_->early_priority(CollapseInfo(this->mesh_, *h)) : 0});
  if (early_ && choices_.size() > kMany)
    std::stable_sort(choices_.begin(), choices_.end(),
                     [](const Choice& a, const Choice& b) { return a.least < b.least; });
  return choices_;
}

template <typename MeshT>
void LazyDecimaterT<MeshT>::judge(VertexHandle v, bool only_legal) {
  Candidate& candidate = candidates_[static_cast<std::size_t>(v.idx())];
  ++candidate.version;
  candidate.queued = candidate.marked = false;
  candidate.changes = 0;
  float best = FLT_MAX;
  for (const Choice& choice : choices(v)) {
    if (choice.least < 0 || choice.least >= best) continue;
    if (only_legal && !this->is_legal(choice.collapse)) continue;
    const float priority = this->collapse_priority(CollapseInfo(this->mesh_, choice.collapse));
    if (priority < 0 || priority >= best) continue;
    best = priority;
    candidate.collapse = choice.collapse;
    candidate.queued = true;
  }
  candidate.edges = static_cast<std::uint32_t>(choices_.size());
  if (candidate.queued) enqueue(v, best, candidate.version);
}

template <typename MeshT>
void LazyDecimaterT<MeshT>::judge_one(HalfedgeHandle h) {
  const CollapseInfo ci(this->mesh_, h);
  const float priority = this->collapse_priority(ci);
  if (priority < 0) return;
  Candidate& candidate = candidates_[static_cast<std::size_t>(ci.v0.idx())];
  candidate.collapse = h;
  candidate.queued = true;
  candidate.marked = false;
  enqueue(ci.v0, priority, ++candidate.version);
}

template <typename MeshT>
void LazyDecimaterT<MeshT>::judge_hub(VertexHandle v) {
  Candidate& candidate = candidates_[static_cast<std::size_t>(v.idx())];
  const HalfedgeHandle h = candidate.collapse;
  candidate.queued = false;
  if (!this->mesh_.status(this->mesh_.edge_handle(h)).deleted() && this->mesh_.from_vertex_handle(h) == v)
    judge_one(h);
  if (candidate.queued) return;
  if (this->planned())
    judge(v, false);  // its one collapse may run along another edge now
  else
    put_off(v);
}

template <typename MeshT>
void LazyDecimaterT<MeshT>::judge_waiting() {
  for (const VertexHandle v : std::exchange(waiting_, {})) {
    const Candidate& candidate = candidates_[static_cast<std::size_t>(v.idx())];
    if (!this->mesh_.status(v).deleted() && !candidate.queued && candidate.changes > 0) judge(v, false);
  }
}

template <typename MeshT>
void LazyDecimaterT<MeshT>::run(bool only_selected) {
  Mesh& mesh = this->mesh_;
  const auto takes_part = [&](VertexHandle v) {
    return !mesh.status(v).deleted() && (!only_selected || mesh.status(v).selected());
  };
  early_ = this->early_priorities();
  queue_ = {};
  turn_ = 0;
  waiting_.clear();
  candidates_.assign(mesh.n_vertices(), Candidate());
  for (const auto v : mesh.all_vertices())
    if (takes_part(v)) judge(v, false);

  // `h` leads from the vertex to the survivor.
  const auto mark = [&](VertexHandle v, HalfedgeHandle h) {
    Candidate& candidate = candidates_[static_cast<std::size_t>(v.idx())];
    candidate.marked = true;
    ++candidate.changes;
    if (candidate.queued || !takes_part(v)) return;
    if (!is_hub_at_rest(candidate)) return judge(v, false);
    if (candidate.changes == 1) put_off(v);
    if (h.is_valid()) judge_one(h);
  };
  while (!this->finished()) {
    if (queue_.empty()) judge_waiting();
    if (queue_.empty()) break;
    const Entry entry = queue_.top();
    queue_.pop();
    const VertexHandle v0(entry.vertex);
    const Candidate& candidate = candidates_[static_cast<std::size_t>(entry.vertex)];
    if (entry.version != candidate.version || mesh.status(v0).deleted()) continue;
    if (candidate.marked) {
      if (is_hub_at_rest(candidate))
        judge_hub(v0);
      else
        judge(v0, false);
      continue;
    }
    if (!this->is_legal(candidate.collapse)) {
      if (is_hub_at_rest(candidate) && candidate.changes > 0 && !this->planned())
        put_off(v0);
      else
        judge(v0, true);
      continue;
    }
    CollapseInfo ci(mesh, candidate.collapse);
    this->execute(ci);
    mark(ci.v1, HalfedgeHandle());
    for (auto h = mesh.cvoh_iter(ci.v1); h.is_valid(); ++h)
      mark(mesh.to_vertex_handle(*h), mesh.opposite_halfedge_handle(*h));
  }
}

}  // namespace whittle
