/// \file
/// A decimater without a heap, for modules that have a plan.
#pragma once

#include <cstddef>
#include <vector>

#include "whittle/openmesh/DriverT.hh"
#include "whittle/openmesh/ModPlannedT.hh"

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

  explicit SweepDecimaterT(Mesh& mesh) : Driver(mesh) {}

  /// Adds a module. The first that has a plan is the one that the sweep follows.
  template <typename Module>
  bool add(OpenMesh::Decimater::ModHandleT<Module>& handle) {
    if (!Driver::add(handle)) return false;
    if (!planned_) planned_ = dynamic_cast<PlannedModule*>(&Driver::module(handle));
    return true;
  }

  template <typename Module>
  bool remove(OpenMesh::Decimater::ModHandleT<Module>& handle) {
    if (handle.is_valid() && planned_ == dynamic_cast<PlannedModule*>(&Driver::module(handle)))
      planned_ = nullptr;
    return Driver::remove(handle);
  }

  /// \return false  no module has a plan, or more than one module is not binary.
  bool initialize() { return planned_ && Driver::initialize(); }

  /// Planned collapses of the last run that were illegal or that another module forbade; 0 if it stopped
  /// early.
  std::size_t refused() const { return refused_; }

 protected:
  void run(bool only_selected) override {
    refused_ = 0;
    std::vector<const Collapse*> pending;
    for (const Collapse& collapse : planned_->plan().collapses) {
      const VertexHandle from(static_cast<int>(collapse.from));
      if (!this->mesh_.status(from).deleted() && (!only_selected || this->mesh_.status(from).selected()))
        pending.push_back(&collapse);
    }
    // What another module refuses now, it may allow once the neighbourhood has changed.
    for (std::size_t before = pending.size() + 1; pending.size() < before;) {
      before = pending.size();
      auto still = pending.begin();
      for (const Collapse* collapse : pending) {
        if (this->finished()) return;
        if (!try_execute(*collapse)) *still++ = collapse;
      }
      pending.erase(still, pending.end());
    }
    refused_ = pending.size();
  }

 private:
  bool try_execute(const Collapse& collapse) {
    const auto edge = this->connectivity_.find(VertexHandle(static_cast<int>(collapse.from)),
                                               VertexHandle(static_cast<int>(collapse.to)));
    if (!edge.is_valid() || !this->is_legal(edge)) return false;
    CollapseInfo ci(this->mesh_, edge);
    if (this->collapse_priority(ci) < 0) return false;
    this->execute(ci);
    return true;
  }

  PlannedModule* planned_ = nullptr;
  std::size_t refused_ = 0;
};

}  // namespace whittle
