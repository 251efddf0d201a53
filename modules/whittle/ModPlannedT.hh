/// \file
/// What all of Whittle's decimater modules share: a plan, looked up collapse by collapse.
#pragma once

#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "whittle/CollapsePlan.hh"
#include "whittle/openmesh.hh"

namespace whittle {

/// A module that has a plan; through it a driver such as SweepDecimaterT gets at the plan of any module.
class PlannedModule {
 public:
  virtual ~PlannedModule() = default;
  /// The plan for the mesh as it is; made at the first call, and anew when a parameter or the mesh has
  /// changed.
  virtual const CollapsePlan& plan() = 0;
};

/// An OpenMesh decimater module over a planner. `initialize()` takes a snapshot of the mesh and plans on it;
/// `collapse_priority()` is a look-up in that plan, so it cannot go stale while the mesh is decimated.
///
/// - As the priority module it allows just the planned collapses, in the order of the plan. In binary mode it
///   forbids every collapse that is not planned.
/// - Vertices with status locked or feature stay. The mesh gets no property and keeps its own.
/// - OpenMesh's decimaters initialise their modules once. For another pass call `initialize()` of the module
///   itself. After a garbage collection the plan is made anew without being asked.
/// - `set_error_tolerance_factor(f)` multiplies the planner's threshold by f.
///
/// \tparam Planner  has `validate()`, `scaled(factor)` and `plan(surface)`, as FaceAngle.
template <typename MeshT, typename Planner>
class ModPlannedT : public OpenMesh::Decimater::ModBaseT<MeshT>, public PlannedModule {
 public:
  using ModBase = OpenMesh::Decimater::ModBaseT<MeshT>;
  using CollapseInfo = OpenMesh::Decimater::CollapseInfoT<MeshT>;

  explicit ModPlannedT(MeshT& mesh) : ModBase(mesh, false) {}

  const Planner& planner() const { return planner_; }

  /// Sets all parameters at once.
  /// \throw InvalidParameter  and the old parameters stay.
  void set_planner(const Planner& planner) {
    planner.validate();
    planner_ = planner;
    n_planned_vertices_ = kNoPlan;
  }

  /// Plans for the mesh as it is now.
  /// \throw InvalidMesh  a face is not a triangle, a coordinate is not finite.
  void initialize() override {
    const auto indexed = to_indexed(this->mesh());
    const SurfaceT<typename MeshT::Scalar> surface(indexed, user_flags(this->mesh()));
    plan_ = planner_.scaled(this->error_tolerance_factor_).plan(surface);
    rank_.assign(indexed.points.size(), kNotPlanned);
    for (std::size_t i = 0; i < plan_.collapses.size(); ++i)
      rank_[plan_.collapses[i].from] = static_cast<std::uint32_t>(i);
    n_planned_vertices_ = indexed.points.size();
  }

  const CollapsePlan& plan() override {
    if (n_planned_vertices_ != this->mesh().n_vertices()) initialize();
    return plan_;
  }

  float collapse_priority(const CollapseInfo& ci) override {
    const Collapse* collapse = planned(ci);
    if (!collapse) return float(ModBase::ILLEGAL_COLLAPSE);
    return this->is_binary() ? float(ModBase::LEGAL_COLLAPSE) : priority(rank_[collapse->from]);
  }

  /// Moves the survivor to its target. OpenMesh refreshes face normals before this call, hence once more
  /// here.
  void postprocess_collapse(const CollapseInfo& ci) override {
    const Collapse* collapse = planned(ci);
    if (!collapse) return;
    auto& mesh = this->mesh();
    auto p = mesh.point(ci.v1);
    bool moved = false;
    for (int i = 0; i < 3; ++i) {
      const auto coordinate = static_cast<typename MeshT::Scalar>(collapse->target[i]);
      moved |= p[i] != coordinate;
      p[i] = coordinate;
    }
    if (!moved) return;
    mesh.set_point(ci.v1, p);
    if (!mesh.has_face_normals()) return;
    for (auto f = mesh.cvf_iter(ci.v1); f.is_valid(); ++f) mesh.set_normal(*f, mesh.calc_face_normal(*f));
  }

  void set_error_tolerance_factor(double factor) override {
    ModBase::set_error_tolerance_factor(factor);
    n_planned_vertices_ = kNoPlan;
  }

 protected:
  /// Changes one parameter: `change([&](Planner& p) { p.max_distance = d; })`.
  template <typename Change>
  void change(Change&& change) {
    Planner planner = planner_;
    std::forward<Change>(change)(planner);
    set_planner(planner);
  }

 private:
  static constexpr std::uint32_t kNotPlanned = 0xffffffffu;
  static constexpr std::size_t kNoPlan = ~std::size_t{0};

  const Collapse* planned(const CollapseInfo& ci) {
    plan();
    const std::uint32_t rank = rank_[static_cast<std::size_t>(ci.v0.idx())];
    if (rank == kNotPlanned || plan_.collapses[rank].to != static_cast<std::uint32_t>(ci.v1.idx()))
      return nullptr;
    return &plan_.collapses[rank];
  }

  /// A float for a rank. As numbers, floats are exact to 2^24 only; positive floats are ordered as their bits
  /// are, which gives more than 2^30 of them. The first is the smallest normal one, for denormals may be
  /// flushed to 0.
  static float priority(std::uint32_t rank) {
    const std::uint32_t bits = 0x00800000u + rank;
    float value = 0;
    static_assert(sizeof value == sizeof bits);
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

  Planner planner_;
  CollapsePlan plan_;
  std::vector<std::uint32_t> rank_;  // of the collapse that removes a vertex
  std::size_t n_planned_vertices_ = kNoPlan;
};

}  // namespace whittle
