/// \file
/// A decimater without a heap, for modules that have a plan.
#pragma once

#include <OpenMesh/Tools/Decimater/BaseDecimaterT.hh>
#include <cstddef>
#include <vector>

#include "whittle/ModPlannedT.hh"

namespace whittle {

/// Use it in place of OpenMesh's DecimaterT where one of the modules is Whittle's: it goes through the plan
/// once, in order, and tests legality and the other modules for the planned collapses only. The result is
/// that of DecimaterT with the same modules, but for collapses that become legal late.
///
/// Unlike DecimaterT, the targets count living vertices and faces, not deleted ones.
template <typename MeshT>
class SweepDecimaterT : public OpenMesh::Decimater::BaseDecimaterT<MeshT> {
 public:
  using Base = OpenMesh::Decimater::BaseDecimaterT<MeshT>;
  using Mesh = MeshT;
  using CollapseInfo = typename Base::CollapseInfo;
  using VertexHandle = typename Mesh::VertexHandle;

  explicit SweepDecimaterT(Mesh& mesh) : Base(mesh), mesh_(mesh) {}

  /// Adds a module. The first that has a plan is the one that the sweep follows.
  template <typename Module>
  bool add(OpenMesh::Decimater::ModHandleT<Module>& handle) {
    if (!Base::add(handle)) return false;
    if (!planned_) planned_ = dynamic_cast<PlannedModule*>(&Base::module(handle));
    return true;
  }

  template <typename Module>
  bool remove(OpenMesh::Decimater::ModHandleT<Module>& handle) {
    if (handle.is_valid() && planned_ == dynamic_cast<PlannedModule*>(&Base::module(handle)))
      planned_ = nullptr;
    return Base::remove(handle);
  }

  /// \return false  no module has a plan, or more than one module is not binary.
  bool initialize() { return planned_ && Base::initialize(); }

  /// Executes up to `n_collapses` collapses, all for 0.
  /// \return how many were executed; `refused()` tells how many were not possible.
  std::size_t decimate(std::size_t n_collapses = 0, bool only_selected = false) {
    return sweep(n_collapses ? n_collapses : ~std::size_t{0}, 0, 0, only_selected);
  }

  /// Down to `n_vertices` living vertices.
  std::size_t decimate_to(std::size_t n_vertices, bool only_selected = false) {
    return sweep(~std::size_t{0}, n_vertices, 0, only_selected);
  }

  /// Until the mesh has at most `n_vertices` living vertices or at most `n_faces` living faces.
  std::size_t decimate_to_faces(std::size_t n_vertices = 0, std::size_t n_faces = 0,
                                bool only_selected = false) {
    return sweep(~std::size_t{0}, n_vertices, n_faces, only_selected);
  }

  /// Planned collapses of the last run that were illegal or that another module forbade; 0 if it stopped
  /// early.
  std::size_t refused() const { return refused_; }

 private:
  std::size_t sweep(std::size_t n_collapses, std::size_t min_vertices, std::size_t min_faces,
                    bool only_selected);

  /// One collapse with all that belongs to it.
  /// \return how many faces vanished; 0 where the collapse is illegal or another module forbids it.
  std::size_t execute(const Collapse& collapse);

  Mesh& mesh_;
  PlannedModule* planned_ = nullptr;
  std::size_t refused_ = 0;
};

template <typename MeshT>
std::size_t SweepDecimaterT<MeshT>::sweep(std::size_t n_collapses, std::size_t min_vertices,
                                          std::size_t min_faces, bool only_selected) {
  refused_ = 0;
  if (!this->is_initialized()) return 0;
  std::size_t vertices = 0, faces = 0, done = 0;
  for (auto v : mesh_.all_vertices()) vertices += !mesh_.status(v).deleted();
  for (auto f : mesh_.all_faces()) faces += !mesh_.status(f).deleted();

  std::vector<const Collapse*> pending;
  for (const Collapse& collapse : planned_->plan().collapses) {
    const VertexHandle from(static_cast<int>(collapse.from));
    if (!mesh_.status(from).deleted() && (!only_selected || mesh_.status(from).selected()))
      pending.push_back(&collapse);
  }
  // What another module refuses now, it may allow once the neighbourhood has changed.
  for (std::size_t before = pending.size() + 1; pending.size() < before;) {
    before = pending.size();
    auto still = pending.begin();
    for (const Collapse* collapse : pending) {
      if (done >= n_collapses || vertices <= min_vertices || faces <= min_faces) return done;
      const std::size_t vanished = execute(*collapse);
      if (vanished == 0) {
        *still++ = collapse;
        continue;
      }
      --vertices;
      faces -= vanished;
      if (!this->notify_observer(++done)) return done;
    }
    pending.erase(still, pending.end());
  }
  refused_ = pending.size();
  return done;
}

template <typename MeshT>
std::size_t SweepDecimaterT<MeshT>::execute(const Collapse& collapse) {
  const auto edge = mesh_.find_halfedge(VertexHandle(static_cast<int>(collapse.from)),
                                        VertexHandle(static_cast<int>(collapse.to)));
  if (!edge.is_valid()) return 0;
  CollapseInfo ci(mesh_, edge);
  if (!this->is_collapse_legal(ci) || this->collapse_priority(ci) < 0) return 0;
  this->preprocess_collapse(ci);
  mesh_.collapse(edge);
  if (mesh_.has_face_normals())
    for (auto f = mesh_.cvf_iter(ci.v1); f.is_valid(); ++f) mesh_.set_normal(*f, mesh_.calc_face_normal(*f));
  this->postprocess_collapse(ci);
  return (ci.fl.is_valid() ? 1u : 0u) + (ci.fr.is_valid() ? 1u : 0u);
}

}  // namespace whittle
