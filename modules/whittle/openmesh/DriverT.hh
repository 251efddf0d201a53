/// \file
/// What Whittle's own decimaters share: OpenMesh's interface, targets, and the execution of a collapse.
#pragma once

#include <OpenMesh/Tools/Decimater/BaseDecimaterT.hh>
#include <algorithm>
#include <cstddef>
#include <vector>

#include "whittle/openmesh/EarlyPriorityT.hh"
#include "whittle/openmesh/HalfedgeCollapse.hh"
#include "whittle/openmesh/PlannedModule.hh"
#include "whittle/openmesh/RunReport.hh"
#include "whittle/openmesh/points_in_space.hh"
#include "whittle/surface/errors.hh"

namespace whittle {

/// A decimater with the interface of OpenMesh's DecimaterT. A driver decides in `run` which collapse comes next. Unlike
/// DecimaterT
/// - it counts living vertices and faces against a target, not deleted ones;
/// - it throws NotReady where DecimaterT returns false or 0: without a module that decides the order, without
///   `initialize()`, or where neither the run nor the module with a plan says where to stop;
/// - `report()` says whether the target of the last run was reached, and why not.
template <typename MeshT>
class DriverT : public OpenMesh::Decimater::BaseDecimaterT<MeshT> {
 public:
  using Base = OpenMesh::Decimater::BaseDecimaterT<MeshT>;
  using Mesh = MeshT;
  using CollapseInfo = typename Base::CollapseInfo;
  using VertexHandle = typename Mesh::VertexHandle;
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;

  explicit DriverT(Mesh& mesh) : Base(mesh), mesh_(mesh), connectivity_(mesh) {
    detail::require_points_in_space<Mesh>();
  }

  template <typename Module>
  bool add(OpenMesh::Decimater::ModHandleT<Module>& handle) {
    if (!Base::add(handle)) return false;
    ++n_modules_;
    if (auto* planned = dynamic_cast<PlannedModule*>(&Base::module(handle))) planned_.push_back(planned);
    if (auto* early = dynamic_cast<EarlyPriorityT<Mesh>*>(&Base::module(handle))) early_.push_back(early);
    return true;
  }

  template <typename Module>
  bool remove(OpenMesh::Decimater::ModHandleT<Module>& handle) {
    if (handle.is_valid()) {
      forget(planned_, Base::module(handle));
      forget(early_, Base::module(handle));
    }
    const bool removed = Base::remove(handle);
    n_modules_ -= removed;
    return removed;
  }

  /// Initialises all modules.
  /// \return true
  /// \throw NotReady  no module decides the order, or several do; a module has no threshold.
  /// \throw InvalidMesh, InvalidParameter  of a module.
  bool initialize() {
    try {
      if (Base::initialize()) return true;
    } catch (...) {
      this->set_uninitialized();
      throw;
    }
    throw NotReady(
        "initialize(): exactly one module must decide the order; add one, and set the others to binary");
  }

  /// What the last run came to.
  const RunReport& report() const { return report_; }

  /// Executes up to `n_collapses` collapses, all that are allowed for 0.
  /// \return how many were executed.
  std::size_t decimate(std::size_t n_collapses = 0, bool only_selected = false) {
    return start({n_collapses ? n_collapses : kNoLimit, 0, 0}, only_selected);
  }

  /// Down to `n_vertices` living vertices.
  std::size_t decimate_to(std::size_t n_vertices, bool only_selected = false) {
    return start({kNoLimit, n_vertices, 0}, only_selected);
  }

  /// Until the mesh has at most `n_vertices` living vertices or at most `n_faces` living faces.
  std::size_t decimate_to_faces(std::size_t n_vertices = 0, std::size_t n_faces = 0,
                                bool only_selected = false) {
    return start({kNoLimit, n_vertices, n_faces}, only_selected);
  }

 protected:
  /// Executes collapses until `finished()` or until there is none.
  virtual void run(bool only_selected) = 0;

  /// Whether the target is met or the observer has called a halt.
  bool finished() const { return halted_ || is_target_met(); }

  /// What OpenMesh's decimaters call legal.
  bool is_legal(HalfedgeHandle h) {
    if constexpr (Mesh::is_trimesh())
      return connectivity_.is_legal(h);
    else  // faces may have more corners
      return this->is_collapse_legal(CollapseInfo(mesh_, h));
  }

  /// The first module with a plan; null if there is none.
  PlannedModule* planned() const { return planned_.empty() ? nullptr : planned_.front(); }

  /// The module that decides the order if it knows priorities early; otherwise null.
  EarlyPriorityT<Mesh>* early_priorities() const {
    const auto found =
        std::find_if(early_.begin(), early_.end(), [](const auto* early) { return early->decides_order(); });
    return found == early_.end() ? nullptr : *found;
  }

  /// Whether the module with the plan is the only one, and nobody observes the run.
  bool is_plan_alone() { return n_modules_ == 1 && planned() && !this->observer(); }

  /// Executes a collapse of the plan that is known to be legal, where the plan is alone.
  /// \param faces  that vanish with it
  /// \param tell   whether the module is told of it; otherwise the caller does that when all is done.
  void execute_planned(std::size_t rank, std::size_t faces, HalfedgeHandle h, bool tell) {
    --vertices_;
    faces_ -= faces;
    ++collapses_;
    if (tell) planned()->before_collapse(h.idx());
    connectivity_.collapse(h);
    if (tell) planned()->after_collapse(rank);
  }

  /// Executes a legal collapse with all that belongs to it.
  void execute(CollapseInfo& ci) {
    --vertices_;
    faces_ -= (ci.fl.is_valid() ? 1u : 0u) + (ci.fr.is_valid() ? 1u : 0u);
    this->preprocess_collapse(ci);
    if constexpr (Mesh::is_trimesh())
      connectivity_.collapse(ci.v0v1);
    else
      mesh_.collapse(ci.v0v1);
    if (mesh_.has_face_normals()) update_normals_around(ci.v1);
    this->postprocess_collapse(ci);
    halted_ = !this->notify_observer(++collapses_);
  }

  Mesh& mesh_;
  detail::HalfedgeCollapseT<Mesh> connectivity_;
  RunReport report_;

 private:
  static constexpr std::size_t kNoLimit = ~std::size_t{0};
  struct Target {
    std::size_t collapses, vertices, faces;  ///< at most so many collapses; stop at so many vertices or faces
  };

  template <typename Kind, typename Module>
  static void forget(std::vector<Kind*>& modules, Module& module) {
    modules.erase(std::remove(modules.begin(), modules.end(), dynamic_cast<Kind*>(&module)), modules.end());
  }

  void update_normals_around(VertexHandle v) {
    for (auto f = mesh_.cvf_iter(v); f.is_valid(); ++f) mesh_.set_normal(*f, mesh_.calc_face_normal(*f));
  }

  std::size_t start(const Target& target, bool only_selected) {
    if (!this->is_initialized())
      throw NotReady("decimate() before initialize(): call initialize() of the decimater first");
    const bool has_target = target.collapses < kNoLimit || target.vertices > 0 || target.faces > 0;
    if (!has_target && planned() && !planned()->has_end())
      throw NotReady(
          "nothing says where to stop: give the module a target or a bound, or call decimate_to_faces()");
    target_ = target;
    report_ = {};
    collapses_ = vertices_ = faces_ = 0;
    halted_ = false;
    for (int v = 0; v < static_cast<int>(mesh_.n_vertices()); ++v)
      vertices_ += !mesh_.status(VertexHandle(v)).deleted();
    for (int f = 0; f < static_cast<int>(mesh_.n_faces()); ++f)
      faces_ += !mesh_.status(typename Mesh::FaceHandle(f)).deleted();
    run(only_selected);
    if (planned()) planned()->finish(only_selected);
    report_.collapses = collapses_;
    report_.faces = faces_;
    report_.vertices = vertices_;
    report_.halted = halted_;
    report_.target_reached =
        has_target ? is_target_met() : !planned() || planned()->is_target_met(faces_, vertices_);
    if (!report_.target_reached && !halted_) explain(only_selected);
    return collapses_;
  }

  bool is_target_met() const {
    return collapses_ >= target_.collapses || vertices_ <= target_.vertices || faces_ <= target_.faces;
  }

  /// Looks at every vertex that is left for the reason why it could not go.
  void explain(bool only_selected) {
    if (planned()) report_.record = planned()->plan().record;
    for (int i = 0; i < static_cast<int>(mesh_.n_vertices()); ++i) {
      const VertexHandle v(i);
      if (mesh_.status(v).deleted() || mesh_.is_isolated(v)) continue;
      bool is_legal_somewhere = false, is_allowed = false;
      for (auto h = mesh_.cvoh_iter(v); h.is_valid() && !is_allowed; ++h) {
        if (!is_legal(*h)) continue;
        is_legal_somewhere = true;
        is_allowed = this->collapse_priority(CollapseInfo(mesh_, *h)) >= 0;
      }
      const auto& status = mesh_.status(v);
      const bool is_left_out = only_selected && !status.selected();
      if (is_left_out || (!is_legal_somewhere && (status.locked() || status.feature())))
        ++report_.held;
      else if (!is_legal_somewhere)
        ++report_.illegal;
      else if (!is_allowed)
        ++report_.forbidden;
    }
  }

  Target target_{};
  std::vector<PlannedModule*> planned_;  // in the order in which they were added
  std::vector<EarlyPriorityT<Mesh>*> early_;
  std::size_t n_modules_ = 0;
  std::size_t collapses_ = 0, vertices_ = 0, faces_ = 0;
  bool halted_ = false;
};

}  // namespace whittle
