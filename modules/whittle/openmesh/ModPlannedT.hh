/// \file
/// What all of Whittle's decimater modules share: a plan, looked up collapse by collapse.
#pragma once

#include <OpenMesh/Core/Utils/Property.hh>
#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "whittle/openmesh/PlanExecutionT.hh"
#include "whittle/openmesh/PlannedModule.hh"
#include "whittle/openmesh/SnapshotT.hh"
#include "whittle/openmesh/attributes.hh"
#include "whittle/openmesh/points_in_space.hh"
#include "whittle/openmesh/refit_mesh.hh"
#include "whittle/plan/CollapsePlan.hh"
#include "whittle/plan/plan_mesh.hh"

namespace whittle {

/// What has become of a plan in a decimater.
struct PlanOutcome {
  std::size_t planned = 0;   ///< collapses in the plan
  std::size_t executed = 0;  ///< of them
  std::size_t illegal = 0;   ///< not executed, and OpenMesh finds them illegal now
  /// Not executed, and their vertices share no edge, for an earlier collapse is missing.
  std::size_t apart = 0;
  /// The rest: forbidden by another module, not selected, or the decimater stopped before.
  std::size_t left = 0;
};

/// An OpenMesh decimater module over a planner. `initialize()` takes a snapshot of the mesh and plans on it;
/// `collapse_priority()` is a look-up in that plan, so it cannot go stale while the mesh is decimated.
///
/// - As the priority module it allows just the planned collapses, in the order of the plan. In binary mode it
///   forbids every collapse that is not planned.
/// - Vertices with status locked or feature stay. So do those on a seam of half-edge texture coordinates, unless the
///   planner merges them along it.
/// - A survivor that moves takes the normal (of unit length), colour and texture coordinates at the nearest
///   point of the mesh as it was at `initialize()`; texture coordinates of half-edges from its own side of a
///   seam, on both sides those at the same place of it. One that stays keeps its own. Face normals are refreshed.
///   Other properties stay as they are, and the mesh gets none.
/// - Where another module forbids a part of a cluster, the survivor lies at the centroid of the vertices that
///   have merged; where it forbids what would have taken a vertex off a seam, that stays on it. The flip guard has not
///   judged these places; see Collapse.
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

  explicit ModPlannedT(MeshT& mesh) : ModBase(mesh, false) { detail::require_points_in_space<MeshT>(); }

  const Planner& planner() const { return planner_; }

  /// Sets all parameters at once.
  /// \throw InvalidParameter  and the old parameters stay.
  void set_planner(const Planner& planner) {
    planner.validate();
    planner_ = planner;
    forget();
  }

  /// How often the planner is run, each time on what the last one leaves; kUntilRest until nothing changes.
  /// All passes are one plan, and the flip guard judges all of them by the input's normals. From 1;
  /// default 1.
  /// \throw InvalidParameter
  void set_passes(std::size_t passes) {
    if (passes == 0) throw InvalidParameter("the number of passes must be at least 1");
    passes_ = passes;
    forget();
  }
  static constexpr std::size_t kUntilRest = ~std::size_t{0};

  /// How many threads plan, where the planner has parts that allow it; the plan is the same for any number.
  /// The default 0 means as many as the machine runs at once.
  void set_threads(std::size_t threads) { threads_ = threads; }

  /// Whether the vertices move at the end of a run to where the mesh's faces fit best what they were at `initialize()`; see
  /// `refit`. Without a value, the default: as the planner has it, that is with mq unless it keeps a bound. Whittle's
  /// drivers do it after the last collapse; with OpenMesh's own call `finish()`.
  void set_refit(std::optional<bool> refit) {
    wants_refit_ = refit;
    forget();
  }

  // What planners have in common is set by the same names; a planner without the parameter has no such setter.

  /// Least cosine between a face's new and original normal. -1..1, default 0.2; -1 turns the flip guard off.
  /// \throw InvalidParameter  and the old value stays; so do all setters.
  template <typename P = Planner>
  auto set_flip_guard(double min_cos) -> decltype(std::declval<P&>().guard, void()) {
    change([&](P& p) { p.guard.min_cos = min_cos; });
  }
  /// Whether boundary vertices may merge along the boundary. Default: they stay.
  template <typename P = Planner>
  auto set_boundary(Boundary boundary) -> decltype(std::declval<P&>().boundary, void()) {
    change([&](P& p) { p.boundary = boundary; });
  }
  /// Whether vertices on seams of half-edge texture coordinates may merge along them. Default: they stay. mq, which has
  /// no such setter, always merges them.
  template <typename P = Planner>
  void set_seams(decltype(std::declval<P&>().seams) seams) {
    change([&](P& p) { p.seams = seams; });
  }
  /// In which order merges are looked at. Default: by index, as in the papers.
  template <typename P = Planner>
  void set_order(decltype(std::declval<P&>().order) order) {
    change([&](P& p) { p.order = order; });
  }
  /// Where vertices merge. Default: as in the papers.
  template <typename P = Planner>
  void set_placement(typename P::Placement placement) {
    change([&](P& p) { p.placement = placement; });
  }

  /// A factor of the threshold for each vertex: 0 keeps the vertex, 1 is neutral, 2 doubles the length or
  /// angle. Where a threshold concerns several vertices, the least factor counts. An invalid handle takes it
  /// back.
  void set_tolerance(OpenMesh::VPropHandleT<float> tolerance) {
    tolerance_ = tolerance;
    forget();
  }

  /// Plans for the mesh as it is now.
  /// \throw InvalidMesh       a face is not a triangle, a coordinate is not finite.
  /// \throw InvalidParameter  a tolerance is negative or not finite.
  void initialize() override {
    const MeshT& mesh = this->mesh();
    forget();
    holds_survivor_ = has_collapsed_ = false;
    n_unsampled_ = 0;
    detail::SnapshotT<MeshT> snapshot(mesh);
    SurfaceExtras extras;
    extras.flags = snapshot.flags();
    const std::vector<std::uint32_t> numbers = detail::corner_numbers(mesh);
    extras.wedges = detail::corner_wedges(mesh, numbers);
    attributes_.take_snapshot(mesh, numbers);
    if (tolerance_.is_valid()) {
      extras.tolerance.assign(mesh.n_vertices(), 1);
      for (const auto v : mesh.vertices())
        extras.tolerance[static_cast<std::size_t>(v.idx())] = mesh.property(tolerance_, v);
    }
    describe(mesh, snapshot.indexed(), extras);
    const bool with_refit = detail::wants_refit(planner_, wants_refit_);
    held_ = with_refit ? detail::refit_flags(snapshot.indexed(), extras) : std::vector<std::uint8_t>();
    const auto enough = [&](const auto& stages) {
      return stages.n_faces() <= enough_faces_ ||
             stages.n_vertices() <= enough_vertices_ + snapshot.n_deleted();
    };
    Planner planner = planner_.scaled(this->error_tolerance_factor_);
    if constexpr (detail::takes_target<Planner>::value)
      if (planner.target_vertices > 0) planner.target_vertices += snapshot.n_deleted();
    execution_ = {
        detail::plan_mesh(planner, snapshot.indexed(), std::move(extras), passes_, threads_, enough).plan,
        mesh.n_vertices()};
    n_planned_vertices_ = mesh.n_vertices();
    if (!with_refit) snapshot.drop_points();
    snapshot_ = std::move(snapshot);
  }

  const CollapsePlan& plan() override {
    if (n_planned_vertices_ != this->mesh().n_vertices()) initialize();
    return execution_.plan();
  }

  bool has_end() const override { return detail::has_end(planner_); }
  bool is_target_met(std::size_t n_faces, std::size_t n_vertices) const override {
    return detail::is_own_target_met(planner_, n_faces, n_vertices);
  }

  float collapse_priority(const CollapseInfo& ci) override {
    const std::uint32_t rank = planned_rank(ci);
    if (rank == Execution::kNotPlanned || !seams_allow(ci.v0v1)) return float(ModBase::ILLEGAL_COLLAPSE);
    return this->is_binary() ? float(ModBase::LEGAL_COLLAPSE) : priority(rank);
  }

  void preprocess_collapse(const CollapseInfo& ci) override {
    if (planned_rank(ci) != Execution::kNotPlanned) before_collapse(ci.v0v1.idx());
  }
  void postprocess_collapse(const CollapseInfo& ci) override {
    const std::uint32_t rank = planned_rank(ci);
    if (rank == Execution::kNotPlanned) return;
    // The decimater has refreshed the normals around the survivor, but not where it lies now.
    if (settle(rank)) refresh_normals(ci.v1);
    attributes_.sample(this->mesh(), ci.v1);
  }

  void after_collapses(std::size_t n) override {
    if (!watches_collapses())
      for (std::size_t rank = 0; rank < n; ++rank) settle(rank);
    n_unsampled_ = n;
  }

  /// After the last collapse, and before garbage collection: refits the mesh, if that is wanted. Whittle's drivers call it.
  /// Again, it does nothing until something collapses.
  void finish(bool only_selected = false) override {
    if (!has_collapsed_) return;
    has_collapsed_ = false;
    std::vector<bool> has_changed(this->mesh().n_vertices(), false);
    refit_report_ = {};
    if (n_planned_vertices_ == this->mesh().n_vertices() && detail::wants_refit(planner_, wants_refit_))
      refit_report_ = detail::refit_mesh(this->mesh(), snapshot_.indexed(), execution_.vertex_map(),
                                         refit_options(only_selected), [&](typename MeshT::VertexHandle v) {
                                           attributes_.move(v);
                                           has_changed[static_cast<std::size_t>(v.idx())] = true;
                                         });
    for (std::size_t rank = 0; rank < n_unsampled_; ++rank) has_changed[execution_.collapse(rank).to] = true;
    n_unsampled_ = 0;
    for (std::uint32_t v = 0; v < has_changed.size(); ++v) {
      if (!has_changed[v] || this->mesh().status(vertex(v)).deleted()) continue;
      attributes_.sample(this->mesh(), vertex(v));
      refresh_normals(vertex(v));
    }
  }
  /// What the last `finish()` did.
  const RefitReport& refit_report() const { return refit_report_; }

  bool is_fresh() const override { return n_planned_vertices_ != kNoPlan && snapshot_.is_of(mesh_ref()); }

  bool watches_collapses() const override { return !attributes_.seams().empty(); }
  void before_collapse(int halfedge) override {
    const typename MeshT::HalfedgeHandle h(halfedge);
    holds_survivor_ = !attributes_.seams().empty() && attributes_.seams().hold(this->mesh(), h);
    attributes_.before(this->mesh(), h);
  }
  void after_collapse(std::size_t rank) override { settle(rank); }

  /// What has become of the plan. Ask before garbage collection, while the mesh has vertex and edge status.
  PlanOutcome outcome() {
    PlanOutcome out;
    out.planned = plan().collapses.size();
    for (std::size_t i = 0; i < out.planned; ++i) {
      const Collapse& collapse = execution_.collapse(i);
      const auto edge = this->mesh().find_halfedge(vertex(collapse.from), vertex(collapse.to));
      if (execution_.is_executed(i))
        ++out.executed;
      else if (!edge.is_valid())
        ++out.apart;
      else if (!this->mesh().is_collapse_ok(edge))
        ++out.illegal;
      else
        ++out.left;
    }
    return out;
  }

  /// For each vertex of the mesh the vertex that it has become; itself if it still stands. Indices are those
  /// before garbage collection.
  std::vector<int> vertex_map() {
    plan();
    return execution_.vertex_map();
  }

  void set_error_tolerance_factor(double factor) override {
    const double before = this->error_tolerance_factor_;
    ModBase::set_error_tolerance_factor(factor);
    if (this->error_tolerance_factor_ != before) forget();
  }

 protected:
  /// Adds what else the planner is to know of the mesh; `extras.flags` has what the user said of each vertex.
  virtual void describe(const MeshT& /*mesh*/, const IndexedMeshT<typename MeshT::Scalar>& /*indexed*/,
                        SurfaceExtras& /*extras*/) {}

  /// The mesh's attributes, from the beginning of `initialize()` on.
  const detail::SurvivorAttributesT<MeshT>& attributes() const { return attributes_; }

  /// Plans no further pass once so few faces or vertices are left.
  void set_enough(std::size_t faces, std::size_t vertices) {
    enough_faces_ = faces;
    enough_vertices_ = vertices;
    forget();
  }

  /// Plans anew when next asked.
  void forget() { n_planned_vertices_ = kNoPlan; }

  /// Changes one parameter: `change([&](Planner& p) { p.max_distance = d; })`.
  template <typename Change>
  void change(Change&& change) {
    Planner planner = planner_;
    std::forward<Change>(change)(planner);
    set_planner(planner);
  }

 private:
  using Execution = detail::PlanExecutionT<MeshT>;
  static constexpr std::size_t kNoPlan = ~std::size_t{0};

  static typename MeshT::VertexHandle vertex(std::uint32_t v) {
    return typename MeshT::VertexHandle(static_cast<int>(v));
  }

  RefitOptions refit_options(bool only_selected) {
    RefitOptions options;
    options.threads = threads_;
    options.flags = held_;
    const auto& mesh = this->mesh();
    for (std::size_t v = 0; v < options.flags.size(); ++v) {
      const auto& status = mesh.status(vertex(static_cast<std::uint32_t>(v)));
      if (status.locked() || status.feature() || (only_selected && !status.selected() && !status.deleted()))
        options.flags[v] |= kLocked;
    }
    return options;
  }

  /// Whether the seams are such by now that they allow a planned collapse: other modules may have forbidden some.
  bool seams_allow(typename MeshT::HalfedgeHandle h) {
    return attributes_.seams().empty() || attributes_.seams().allow_planned(this->mesh(), h);
  }

  /// After a collapse: the survivor comes to its place, and takes its values later.
  /// \return whether it has moved
  bool settle(std::size_t rank) {
    const bool moved = execution_.settle(this->mesh(), rank, holds_survivor_);
    has_collapsed_ = true;
    const Collapse& collapse = execution_.collapse(rank);
    attributes_.merge(this->mesh(), vertex(collapse.from), vertex(collapse.to), moved);
    return moved;
  }

  void refresh_normals(typename MeshT::VertexHandle v) {
    auto& mesh = this->mesh();
    if (!mesh.has_face_normals()) return;
    for (auto f = mesh.cvf_iter(v); f.is_valid(); ++f) mesh.set_normal(*f, mesh.calc_face_normal(*f));
  }

  const MeshT& mesh_ref() const { return const_cast<ModPlannedT*>(this)->ModBase::mesh(); }

  std::uint32_t planned_rank(const CollapseInfo& ci) {
    plan();
    return execution_.rank(ci.v0, ci.v1);
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
  std::size_t passes_ = 1, threads_ = 0;
  std::optional<bool> wants_refit_;
  std::size_t enough_faces_ = 0, enough_vertices_ = 0;
  OpenMesh::VPropHandleT<float> tolerance_;
  Execution execution_;
  detail::SnapshotT<MeshT> snapshot_;  // of the mesh when the plan was made
  detail::SurvivorAttributesT<MeshT> attributes_;
  std::vector<std::uint8_t> held_;  // what stays in a refit
  RefitReport refit_report_;
  bool has_collapsed_ = false;  // since the last `finish()`
  // How many of the plan's first collapses have survivors that have yet to take their values.
  std::size_t n_unsampled_ = 0;
  bool holds_survivor_ = false;  // a seam does, in the collapse that is under way
  std::size_t n_planned_vertices_ = kNoPlan;
};

}  // namespace whittle
