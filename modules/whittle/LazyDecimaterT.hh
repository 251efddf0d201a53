/// \file
/// A decimater for any set of modules that tests a collapse only when its turn comes.
#pragma once

#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <vector>

#include "whittle/openmesh/DriverT.hh"

namespace whittle {

/// Use it in place of OpenMesh's DecimaterT. That one tests the legality of every collapse around every
/// vertex that a collapse touches, and most of these collapses never come up. This one asks the modules for
/// priorities first, and tests legality when a collapse is the best of all. After a collapse the vertices
/// around the survivor are marked; a marked vertex is judged anew when it comes up. So a vertex whose
/// priority has improved may come up late, which makes the order differ a little from DecimaterT's, and with
/// it the mesh; with planned modules it does not. Equal priorities go by vertex index.
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
    bool operator<(const Entry& other) const {  // std::priority_queue has the largest on top
      return priority != other.priority ? priority > other.priority : vertex > other.vertex;
    }
  };
  struct Candidate {
    HalfedgeHandle collapse;    ///< the best one that removes this vertex
    std::uint32_t version = 0;  ///< queue entries of an older version are void
    bool queued = false;
    bool marked = false;  ///< its neighbourhood has changed since it was judged
  };

  /// Judges the collapses that remove `v`, legal or not unless `only_legal`, and queues the best.
  void judge(VertexHandle v, bool only_legal);

  std::vector<Candidate> candidates_;
  std::priority_queue<Entry> queue_;
};

template <typename MeshT>
void LazyDecimaterT<MeshT>::judge(VertexHandle v, bool only_legal) {
  Candidate& candidate = candidates_[static_cast<std::size_t>(v.idx())];
  ++candidate.version;
  candidate.queued = candidate.marked = false;
  float best = FLT_MAX;
  for (auto h = this->mesh_.cvoh_iter(v); h.is_valid(); ++h) {
    if (only_legal && !this->is_legal(*h)) continue;
    const CollapseInfo ci(this->mesh_, *h);
    const float priority = this->collapse_priority(ci);
    if (priority < 0 || priority >= best) continue;
    best = priority;
    candidate.collapse = *h;
    candidate.queued = true;
    if (best == 0) break;  // nothing can be better
  }
  if (candidate.queued) queue_.push({best, v.idx(), candidate.version});
}

template <typename MeshT>
void LazyDecimaterT<MeshT>::run(bool only_selected) {
  Mesh& mesh = this->mesh_;
  const auto takes_part = [&](VertexHandle v) {
    return !mesh.status(v).deleted() && (!only_selected || mesh.status(v).selected());
  };
  queue_ = {};
  candidates_.assign(mesh.n_vertices(), Candidate());
  for (const auto v : mesh.all_vertices())
    if (takes_part(v)) judge(v, false);

  const auto mark = [&](VertexHandle v) {
    Candidate& candidate = candidates_[static_cast<std::size_t>(v.idx())];
    candidate.marked = true;
    if (!candidate.queued && takes_part(v)) judge(v, false);
  };
  while (!queue_.empty() && !this->finished()) {
    const Entry entry = queue_.top();
    queue_.pop();
    const VertexHandle v0(entry.vertex);
    const Candidate& candidate = candidates_[static_cast<std::size_t>(entry.vertex)];
    if (entry.version != candidate.version || mesh.status(v0).deleted()) continue;
    if (candidate.marked) {
      judge(v0, false);
      continue;
    }
    if (!this->is_legal(candidate.collapse)) {
      judge(v0, true);
      continue;
    }
    CollapseInfo ci(mesh, candidate.collapse);
    this->execute(ci);
    mark(ci.v1);
    for (auto v = mesh.cvv_iter(ci.v1); v.is_valid(); ++v) mark(*v);
  }
}

}  // namespace whittle
