/// \file
/// What all of Whittle's decimater modules share: a plan, looked up collapse by collapse.
#pragma once

#include <Eigen/Core>
#include <OpenMesh/Core/Utils/Property.hh>
#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <utility>
#include <vector>

#include "whittle/openmesh/PlannedModule.hh"
#include "whittle/openmesh/SnapshotT.hh"
#include "whittle/openmesh/attributes.hh"
#include "whittle/openmesh/points_in_space.hh"
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
    detail::SnapshotT<MeshT> snapshot(mesh);
    SurfaceExtras extras;
    extras.flags = snapshot.flags();
    extras.wedges = detail::corner_wedges(mesh);
    if (tolerance_.is_valid()) {
      extras.tolerance.assign(mesh.n_vertices(), 1);
      for (const auto v : mesh.vertices())
        extras.tolerance[static_cast<std::size_t>(v.idx())] = mesh.property(tolerance_, v);
    }
    describe(mesh, snapshot.indexed(), extras);
    const auto enough = [&](const auto& stages) {
      return stages.n_faces() <= enough_faces_ ||
             stages.n_vertices() <= enough_vertices_ + snapshot.n_deleted();
    };
    Planner planner = planner_.scaled(this->error_tolerance_factor_);
    if constexpr (detail::takes_target<Planner>::value)
      if (planner.target_vertices > 0) planner.target_vertices += snapshot.n_deleted();
    plan_ = detail::plan_mesh(planner, snapshot.indexed(), std::move(extras), passes_, threads_, enough).plan;
    rank_.assign(mesh.n_vertices(), kNotPlanned);
    for (std::size_t i = 0; i < plan_.collapses.size(); ++i)
      rank_[plan_.collapses[i].from] = static_cast<std::uint32_t>(i);
    executed_.assign(plan_.collapses.size(), false);
    placed_by_.assign(mesh.n_vertices(), 0);
    attributes_.take_snapshot(mesh);
    n_planned_vertices_ = mesh.n_vertices();
    snapshot.drop_points();
    snapshot_ = std::move(snapshot);
  }

  const CollapsePlan& plan() override {
    if (n_planned_vertices_ != this->mesh().n_vertices()) initialize();
    return plan_;
  }

  bool has_end() const override { return detail::has_end(planner_); }
  bool is_target_met(std::size_t n_faces, std::size_t n_vertices) const override {
    return detail::is_own_target_met(planner_, n_faces, n_vertices);
  }

  float collapse_priority(const CollapseInfo& ci) override {
    const Collapse* collapse = planned(ci);
    if (!collapse || !seams_allow(ci.v0v1)) return float(ModBase::ILLEGAL_COLLAPSE);
    return this->is_binary() ? float(ModBase::LEGAL_COLLAPSE) : priority(rank_[collapse->from]);
  }

  void preprocess_collapse(const CollapseInfo& ci) override {
    if (planned(ci)) before_collapse(ci.v0v1.idx());
  }
  void postprocess_collapse(const CollapseInfo& ci) override {
    // The decimater has refreshed the normals around the survivor, but not where it lies now.
    if (const Collapse* collapse = planned(ci))
      if (settle(rank_[collapse->from])) refresh_normals(ci.v1);
  }

  void after_collapses(std::size_t n) override {
    for (std::size_t rank = 0; rank < n; ++rank) {
      executed_[rank] = true;
      place_survivor(rank);
    }
  }

  bool is_fresh() const override { return n_planned_vertices_ != kNoPlan && snapshot_.is_of(mesh_ref()); }

  bool watches_collapses() const override { return mesh_ref().has_face_normals() || !attributes_.empty(); }
  void before_collapse(int halfedge) override {
    const typename MeshT::HalfedgeHandle h(halfedge);
    holds_survivor_ = !attributes_.seams().empty() && attributes_.seams().hold(this->mesh(), h);
    attributes_.before(this->mesh(), h);
  }
  void after_collapse(std::size_t rank) override {
    settle(rank);
    refresh_normals(vertex(plan_.collapses[rank].to));
  }

  /// What has become of the plan. Ask before garbage collection, while the mesh has vertex and edge status.
  PlanOutcome outcome() {
    PlanOutcome out;
    out.planned = plan().collapses.size();
    for (std::size_t i = 0; i < out.planned; ++i) {
      const auto edge =
          this->mesh().find_halfedge(vertex(plan_.collapses[i].from), vertex(plan_.collapses[i].to));
      if (executed_[i])
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
    std::vector<int> map(this->mesh().n_vertices());
    std::iota(map.begin(), map.end(), 0);
    for (std::size_t i = plan_.collapses.size(); i-- > 0;)
      if (executed_[i]) map[plan_.collapses[i].from] = map[plan_.collapses[i].to];
    return map;
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
  using Point = Eigen::Matrix<typename MeshT::Scalar, 3, 1>;
  static constexpr std::uint32_t kNotPlanned = 0xffffffffu;
  static constexpr std::size_t kNoPlan = ~std::size_t{0};

  static typename MeshT::VertexHandle vertex(std::uint32_t v) {
    return typename MeshT::VertexHandle(static_cast<int>(v));
  }

  /// Whether the seams are such by now that they allow a planned collapse: other modules may have forbidden some.
  bool seams_allow(typename MeshT::HalfedgeHandle h) {
    return attributes_.seams().empty() || attributes_.seams().allow_planned(this->mesh(), h);
  }

  /// Moves the survivor of a collapse that has been executed to its place, with its attributes.
  /// \return whether it has moved
  bool settle(std::size_t rank) {
    executed_[rank] = true;
    const bool moved = place_survivor(rank);
    const Collapse& collapse = plan_.collapses[rank];
    attributes_.after(this->mesh(), vertex(collapse.from), vertex(collapse.to), moved);
    return moved;
  }

  void refresh_normals(typename MeshT::VertexHandle v) {
    auto& mesh = this->mesh();
    if (!mesh.has_face_normals()) return;
    for (auto f = mesh.cvf_iter(v); f.is_valid(); ++f) mesh.set_normal(*f, mesh.calc_face_normal(*f));
  }

  const MeshT& mesh_ref() const { return const_cast<ModPlannedT*>(this)->ModBase::mesh(); }

  const Collapse* planned(const CollapseInfo& ci) {
    plan();
    const std::uint32_t rank = rank_[static_cast<std::size_t>(ci.v0.idx())];
    if (rank == kNotPlanned || plan_.collapses[rank].to != static_cast<std::uint32_t>(ci.v1.idx()))
      return nullptr;
    return &plan_.collapses[rank];
  }

  /// Moves the survivor of a collapse that has been executed to where its cluster, or the part of it that has
  /// merged by now, belongs.
  /// \return whether it has moved
  bool place_survivor(std::size_t rank) {
    const Collapse& collapse = plan_.collapses[rank];
    const auto v0 = vertex(collapse.from), v1 = vertex(collapse.to);
    // A decimater that does not go by rank may come to a stage's collapse after those of a later stage.
    const auto last = static_cast<std::uint32_t>(rank) + collapse.rest;
    std::uint32_t& placed_by = placed_by_[collapse.to];
    if (last < placed_by) return false;
    placed_by = last;

    auto& mesh = this->mesh();
    auto p = mesh.point(v1);
    const Point before(p[0], p[1], p[2]);
    Point after = collapse.target.template cast<typename MeshT::Scalar>();
    if (const std::size_t merged = n_merged(rank); merged > 0) {
      const auto& from = mesh.point(v0);
      after = detail::place_of_part<typename MeshT::Scalar>(before, {from[0], from[1], from[2]},
                                                            collapse.target, merged);
    }
    const bool is_held = mesh.has_vertex_status() && (mesh.status(v1).locked() || mesh.status(v1).feature());
    if (after == before || is_held) return false;  // it may have been locked since the plan was made
    if (holds_survivor_ && is_off(v0, before, after)) return false;
    for (std::uint32_t i = 0; i < 3; ++i) p[i] = after[i];
    mesh.set_point(v1, p);
    return true;
  }

  /// Whether the target of a survivor that a seam holds is elsewhere, by more than the planner's rounding.
  bool is_off(typename MeshT::VertexHandle from, const Point& before, const Point& after) {
    constexpr auto kRounding = static_cast<typename MeshT::Scalar>(0.1);  // of the edge
    const auto& p = this->mesh().point(from);
    return (after - before).norm() > kRounding * (Point(p[0], p[1], p[2]) - before).norm();
  }

  /// How many vertices of a cluster its survivor stands for, itself included; 0 if that is all of them.
  std::size_t n_merged(std::size_t rank) const {
    const auto& collapses = plan_.collapses;
    const std::size_t last = rank + collapses[rank].rest;
    std::size_t first = rank;
    while (first > 0 && collapses[first - 1].rest > 0) --first;
    std::size_t executed = 0;
    for (std::size_t i = first; i <= last; ++i) executed += executed_[i];
    return executed == last - first + 1 ? 0 : executed + 1;
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
  std::size_t enough_faces_ = 0, enough_vertices_ = 0;
  OpenMesh::VPropHandleT<float> tolerance_;
  CollapsePlan plan_;
  std::vector<std::uint32_t> rank_;    // of the collapse that removes a vertex
  std::vector<bool> executed_;         // for each collapse of the plan
  detail::SnapshotT<MeshT> snapshot_;  // of the mesh when the plan was made
  // For each survivor the last rank of the latest cluster that has moved it.
  std::vector<std::uint32_t> placed_by_;
  detail::SurvivorAttributesT<MeshT> attributes_;
  bool holds_survivor_ = false;  // a seam does, in the collapse that is under way
  std::size_t n_planned_vertices_ = kNoPlan;
};

}  // namespace whittle
