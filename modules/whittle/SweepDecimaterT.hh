/// \file
/// A decimater without a heap, for modules that have a plan.
#pragma once

#include <cstddef>
#include <vector>

#include "whittle/openmesh/DriverT.hh"
#include "whittle/openmesh/ModPlannedT.hh"
#include "whittle/openmesh/RingPrefetchT.hh"

namespace whittle {

/// Use it in place of OpenMesh's DecimaterT where one of the modules is Whittle's: it goes through the plan
/// once, in order, and tests legality and the other modules for the planned collapses only. With planned
/// modules alone the result is that of DecimaterT, bit for bit; with constraints the order of retries may
/// differ.
template <typename MeshT>
class SweepDecimaterT : public DriverT<MeshT> {
 public:
  using Driver = DriverT<MeshT>;
  using Mesh = MeshT;
  using CollapseInfo = typename Driver::CollapseInfo;
  using VertexHandle = typename Driver::VertexHandle;
  using HalfedgeHandle = typename Driver::HalfedgeHandle;

  explicit SweepDecimaterT(Mesh& mesh) : Driver(mesh) {}

  /// \throw NotReady  no module has a plan; and as DriverT.
  bool initialize() {
    if (!this->planned())
      throw NotReady("SweepDecimaterT: no module has a plan; add one of Whittle's, or use LazyDecimaterT");
    return Driver::initialize();
  }

  /// Planned collapses of the last run that were illegal or that another module forbade; 0 if it stopped early.
  std::size_t refused() const { return this->report().refused; }

 protected:
  void run(bool only_selected) override {
    if constexpr (Mesh::is_trimesh())
      if (!only_selected && this->is_plan_alone() && this->planned()->is_fresh()) return run_proved();
    run_tested(only_selected);
  }

 private:
  /// The plan is alone on the mesh that it was made for: every collapse is legal in its turn.
  void run_proved() {
    const std::vector<Collapse>& collapses = this->planned()->plan().collapses;
    detail::RingPrefetchT<Mesh, false> ahead(this->mesh_);
    const bool one_by_one = this->planned()->watches_collapses();
    std::size_t n = 0;
    for (; n < collapses.size() && !this->finished(); ++n) {
      if (n + ahead.kAhead < collapses.size()) announce(collapses[n + ahead.kAhead], ahead);
      this->execute_planned(n, collapses[n].faces, find(collapses[n]), one_by_one);
    }
    this->planned()->after_collapses(n);
  }

  /// Asks other modules and tests legality.
  void run_tested(bool only_selected) {
    std::vector<const Collapse*> pending;
    for (const Collapse& collapse : this->planned()->plan().collapses) {
      const VertexHandle from(static_cast<int>(collapse.from));
      if (!this->mesh_.status(from).deleted() && (!only_selected || this->mesh_.status(from).selected()))
        pending.push_back(&collapse);
    }
    // What another module refuses now, it may allow once the neighbourhood has changed.
    for (std::size_t before = pending.size() + 1; pending.size() < before;) {
      before = pending.size();
      detail::RingPrefetchT<Mesh, true> ahead(this->mesh_);
      auto still = pending.begin();
      for (std::size_t i = 0; i < before; ++i) {
        if (this->finished()) return;
        if (i + ahead.kAhead < before) announce(*pending[i + ahead.kAhead], ahead);
        const Collapse* const collapse = pending[i];
        if (!try_execute(*collapse)) *still++ = collapse;
      }
      pending.erase(still, pending.end());
    }
    this->report_.refused = pending.size();
  }

  template <typename Prefetch>
  static void announce(const Collapse& later, Prefetch& ahead) {
    ahead.announce(VertexHandle(static_cast<int>(later.from)), VertexHandle(static_cast<int>(later.to)));
  }
  HalfedgeHandle find(const Collapse& collapse) const {
    return this->connectivity_.find(VertexHandle(static_cast<int>(collapse.from)),
                                    VertexHandle(static_cast<int>(collapse.to)));
  }
  bool try_execute(const Collapse& collapse) {
    const HalfedgeHandle edge = find(collapse);
    if (!edge.is_valid() || !this->is_legal(edge)) return false;
    CollapseInfo ci(this->mesh_, edge);
    if (this->collapse_priority(ci) < 0) return false;
    this->execute(ci);
    return true;
  }
};

}  // namespace whittle
