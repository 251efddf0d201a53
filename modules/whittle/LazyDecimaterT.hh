/// \file
/// A decimater for any set of modules that tests a collapse only when its turn comes.
#pragma once

#include <OpenMesh/Tools/Decimater/BaseDecimaterT.hh>
#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <vector>

namespace whittle {

/// Use it in place of OpenMesh's DecimaterT. That one tests the legality of every collapse around every
/// vertex that a collapse touches, and most of these collapses never come up. This one asks the modules for
/// priorities first, and tests legality when a collapse is the best of all. After a collapse the vertices
/// around the survivor are marked; a marked vertex is judged anew when it comes up. So a vertex whose
/// priority has improved may come up late, which makes the order differ a little from DecimaterT's, and with
/// it the mesh; with planned modules it does not.
///
/// Unlike DecimaterT, equal priorities go by vertex index, and targets count living vertices and faces.
template <typename MeshT>
class LazyDecimaterT : public OpenMesh::Decimater::BaseDecimaterT<MeshT> {
 public:
  using Base = OpenMesh::Decimater::BaseDecimaterT<MeshT>;
  using Mesh = MeshT;
  using CollapseInfo = typename Base::CollapseInfo;
  using VertexHandle = typename Mesh::VertexHandle;
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;

  explicit LazyDecimaterT(Mesh& mesh) : Base(mesh), mesh_(mesh) {}

  /// Executes up to `n_collapses` collapses, all that are allowed for 0.
  /// \return how many were executed.
  std::size_t decimate(std::size_t n_collapses = 0, bool only_selected = false) {
    return run(n_collapses ? n_collapses : ~std::size_t{0}, 0, 0, only_selected);
  }

  /// Down to `n_vertices` living vertices.
  std::size_t decimate_to(std::size_t n_vertices, bool only_selected = false) {
    return run(~std::size_t{0}, n_vertices, 0, only_selected);
  }

  /// Until the mesh has at most `n_vertices` living vertices or at most `n_faces` living faces.
  std::size_t decimate_to_faces(std::size_t n_vertices = 0, std::size_t n_faces = 0,
                                bool only_selected = false) {
    return run(~std::size_t{0}, n_vertices, n_faces, only_selected);
  }

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

  std::size_t run(std::size_t n_collapses, std::size_t min_vertices, std::size_t min_faces,
                  bool only_selected);

  /// Judges the collapses that remove `v`, legal or not unless `only_legal`, and queues the best.
  void judge(VertexHandle v, bool only_legal);

  Mesh& mesh_;
  std::vector<Candidate> candidates_;
  std::priority_queue<Entry> queue_;
};

template <typename MeshT>
void LazyDecimaterT<MeshT>::judge(VertexHandle v, bool only_legal) {
  Candidate& candidate = candidates_[static_cast<std::size_t>(v.idx())];
  ++candidate.version;
  candidate.queued = candidate.marked = false;
  float best = FLT_MAX;
  for (auto h = mesh_.cvoh_iter(v); h.is_valid(); ++h) {
    const CollapseInfo ci(mesh_, *h);
    if (only_legal && !this->is_collapse_legal(ci)) continue;
    const float priority = this->collapse_priority(ci);
    if (priority < 0 || priority >= best) continue;
    best = priority;
    candidate.collapse = *h;
    candidate.queued = true;
  }
  if (candidate.queued) queue_.push({best, v.idx(), candidate.version});
}

template <typename MeshT>
std::size_t LazyDecimaterT<MeshT>::run(std::size_t n_collapses, std::size_t min_vertices,
                                       std::size_t min_faces, bool only_selected) {
  if (!this->is_initialized()) return 0;
  std::size_t vertices = 0, faces = 0, done = 0;
  const auto takes_part = [&](VertexHandle v) {
    return !mesh_.status(v).deleted() && (!only_selected || mesh_.status(v).selected());
  };
  queue_ = {};
  candidates_.assign(mesh_.n_vertices(), Candidate());
  for (const auto v : mesh_.all_vertices()) {
    vertices += !mesh_.status(v).deleted();
    if (takes_part(v)) judge(v, false);
  }
  for (const auto f : mesh_.all_faces()) faces += !mesh_.status(f).deleted();

  while (!queue_.empty() && done < n_collapses && vertices > min_vertices && faces > min_faces) {
    const Entry entry = queue_.top();
    queue_.pop();
    const VertexHandle v0(entry.vertex);
    Candidate& candidate = candidates_[static_cast<std::size_t>(entry.vertex)];
    if (entry.version != candidate.version || mesh_.status(v0).deleted()) continue;
    if (candidate.marked) {
      judge(v0, false);
      continue;
    }
    CollapseInfo ci(mesh_, candidate.collapse);
    if (!this->is_collapse_legal(ci)) {
      judge(v0, true);
      continue;
    }
    --vertices;
    faces -= (ci.fl.is_valid() ? 1u : 0u) + (ci.fr.is_valid() ? 1u : 0u);
    this->preprocess_collapse(ci);
    mesh_.collapse(ci.v0v1);
    if (mesh_.has_face_normals())
      for (auto f = mesh_.cvf_iter(ci.v1); f.is_valid(); ++f)
        mesh_.set_normal(*f, mesh_.calc_face_normal(*f));
    this->postprocess_collapse(ci);

    const auto mark = [&](VertexHandle v) {
      Candidate& near = candidates_[static_cast<std::size_t>(v.idx())];
      near.marked = true;
      if (!near.queued && takes_part(v)) judge(v, false);
    };
    mark(ci.v1);
    for (auto v = mesh_.cvv_iter(ci.v1); v.is_valid(); ++v) mark(*v);
    if (!this->notify_observer(++done)) break;
  }
  return done;
}

}  // namespace whittle
