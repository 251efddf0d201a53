/// \file
/// The one call that simplifies a mesh: an OpenMesh mesh in place, with all that it carries, or plain arrays.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "whittle/SweepDecimaterT.hh"
#include "whittle/compact.hh"
#include "whittle/openmesh/ModPlannedT.hh"
#include "whittle/openmesh/RunReport.hh"
#include "whittle/openmesh/StatusesT.hh"
#include "whittle/openmesh/convert.hh"
#include "whittle/openmesh/describe.hh"
#include "whittle/plan/SeamRecord.hh"
#include "whittle/plan/TargetCount.hh"
#include "whittle/plan/execute.hh"
#include "whittle/plan/locks.hh"
#include "whittle/plan/plan_mesh.hh"
#include "whittle/planners/MemorylessQuadric.hh"

namespace whittle {

/// What `decimate` is told besides the mesh. Set one of `ratio`, `faces` and `vertices`, or `max_distance`, or both; a
/// planner with a threshold needs none of them.
struct DecimateOptions {
  std::optional<double> ratio;          ///< of the faces that stay, in (0, 1]
  std::optional<std::size_t> faces;     ///< at most so many stay
  std::optional<std::size_t> vertices;  ///< at most so many stay, isolated ones included

  /// No vertex of the input lies farther than this from the faces that it is left with, nor these, at their middles and
  /// corners, from the input; a vertex's tolerance is a factor. Model units, >= 0; HUGE_VAL, the default: no bound. Only
  /// MemorylessQuadric keeps a bound.
  double max_distance = HUGE_VAL;

  /// Boundary vertices stay. Otherwise they may merge along the boundary, if the planner's parameters allow it;
  /// MemorylessQuadric always does.
  bool lock_boundary = false;
  /// Both ends of an edge stay if the normals of its faces differ by more. Degrees, 0..180; 180: none.
  double lock_feature_angle = 180;
  /// Vertices with OpenMesh's status *selected* stay, as locked and feature ones always do.
  bool lock_selected = false;

  /// Each chart, what the boundary and seams of half-edge texture coordinates, or of wedges, enclose, keeps a face at
  /// least. Otherwise a chart may vanish, and its neighbours close over it.
  bool keep_charts = false;

  /// For each vertex a factor of `max_distance` and of the planner's threshold: 0 keeps the vertex, 1 is neutral.
  /// >= 0. An invalid handle: none.
  OpenMesh::VPropHandleT<float> tolerance = OpenMesh::VPropHandleT<float>();
  /// For each vertex how much its error counts: 1 is neutral, 4 as much as a tolerance of 1/2. > 0.
  OpenMesh::VPropHandleT<float> weight = OpenMesh::VPropHandleT<float>();
  /// Lets differences of normals, colours and texture coordinates count beside the shape, as lengths. Only
  /// MemorylessQuadric looks at them.
  ValueWeights values;

  std::size_t passes = 0;   ///< how often the planner runs at most; 0: once, or as often as the target needs
  std::size_t threads = 0;  ///< 0: as many as the machine runs at once; the result is the same for any number
};

/// What came of it.
struct DecimateReport {
  std::size_t faces_before = 0, vertices_before = 0;  ///< without elements that were deleted already
  std::size_t faces = 0, vertices = 0;                ///< left
  bool target_reached = true;                         ///< true where none was given
  std::string why;  ///< why the target was not reached, in one line; else empty
  /// Vertices of the input that are locked, features, selected or on a locked boundary.
  std::size_t held = 0;
  std::size_t seams = 0;        ///< vertices of the input that stay as they lie on seams, which do not move
  std::size_t charts = 0;       ///< of the input, what its seams enclose; 0 where it has no seams
  std::size_t charts_gone = 0;  ///< of these, how many have no face left
  PlanRecord record;            ///< merges planned, and refused by flip guard, link condition and bound
  /// For each vertex of the input, by its index there, the vertex of the result that it became; kNoVertex if none.
  std::vector<std::uint32_t> vertex_map;
  static constexpr std::uint32_t kNoVertex = 0xffffffffu;
};

/// The same of plain arrays, with the result.
template <typename Real>
struct DecimatedT : DecimateReport {
  IndexedMeshT<Real> mesh;                 ///< vertices and faces in their old order
  std::vector<std::uint32_t> face_origin;  ///< for each face of the result the face of the input that it was
};

namespace detail {

/// \throw InvalidParameter
inline TargetCount make_target(const DecimateOptions& options, std::size_t n_faces) {
  if (options.ratio.has_value() + options.faces.has_value() + options.vertices.has_value() > 1)
    throw InvalidParameter("decimate: only one of ratio, faces and vertices can be the target");
  if (options.ratio && !(*options.ratio > 0 && *options.ratio <= 1))
    throw InvalidParameter("decimate: the ratio is " + std::to_string(*options.ratio) +
                           "; it must be above 0 and at most 1, as 0.1 for a tenth of the faces");
  if (options.faces == 0u || options.vertices == 0u)
    throw InvalidParameter("decimate: a target of 0 faces or vertices would leave nothing; the least is 1");
  if (!(options.lock_feature_angle >= 0 && options.lock_feature_angle <= 180))
    throw InvalidParameter("decimate: the feature angle must be in 0..180 degrees");
  TargetCount target;
  if (options.ratio)
    target.faces =
        std::max<std::size_t>(1, static_cast<std::size_t>(*options.ratio * static_cast<double>(n_faces)));
  if (options.faces) target.faces = *options.faces;
  if (options.vertices) target.vertices = *options.vertices;
  return target;
}

/// The planner with what the options say of it.
/// \throw InvalidParameter, NotReady
template <typename Planner>
Planner with_options(Planner planner, const DecimateOptions& options, const TargetCount& target) {
  if (!(options.max_distance >= 0))
    throw InvalidParameter("decimate: max_distance must be a length of at least 0");
  options.values.validate();
  if constexpr (takes_target<Planner>::value) {
    if (target.any()) {
      planner.target_faces = target.faces;
      planner.target_vertices = target.vertices;
    }
    planner.max_distance = std::min(planner.max_distance, options.max_distance);
    planner.keep_charts = planner.keep_charts || options.keep_charts;
  } else {
    if (options.max_distance < HUGE_VAL)
      throw InvalidParameter(
          "decimate: only MemorylessQuadric keeps max_distance; leave the bound or the planner out");
    if (options.values.any())
      throw InvalidParameter(
          "decimate: only MemorylessQuadric looks at values; leave them or the planner out");
  }
  planner.validate();
  if (!has_end(planner))
    throw NotReady("decimate: nothing says where to stop: set ratio, faces, vertices or max_distance");
  return planner;
}

template <typename Planner>
std::size_t passes_of(const DecimateOptions& options, const TargetCount& target) {
  if (options.passes > 0) return options.passes;
  return target.any() && !takes_target<Planner>::value ? kPassesToTarget : 1;
}

/// Adds the locks that the shape decides.
template <typename Real>
void add_locks(const IndexedMeshT<Real>& mesh, const DecimateOptions& options,
               std::vector<std::uint8_t>& flags) {
  flags.resize(mesh.points.size(), 0);
  if (!options.lock_boundary && options.lock_feature_angle >= 180) return;
  const SurfaceT<Real> surface(mesh, {}, options.threads);
  if (options.lock_boundary) lock_boundary(surface, flags);
  if (options.lock_feature_angle < 180) lock_features(surface, options.lock_feature_angle, flags);
}

/// Counts the vertices that the planner leaves where they are, and the charts that are gone.
/// \param flags        of the user, for each vertex
/// \param face_origin  for each face that is left, the face that it was
inline void count(const std::vector<std::uint8_t>& flags, const SeamRecord& seams, bool seams_move,
                  const std::vector<std::uint32_t>& face_origin, DecimateReport& report) {
  const bool all_move = seams_move && !seams.empty();
  for (std::size_t v = 0; v < flags.size(); ++v) {
    const bool is_held = (flags[v] & (kLocked | kFeature)) != 0;
    report.held += is_held;
    report.seams += !is_held && !all_move && ((flags[v] & kSeam) != 0 || seams.has(v));
  }
  if (seams.empty()) return;
  report.charts = seams.charts.count;
  report.charts_gone = count_vanished(seams.charts, face_origin);
}

/// Fills in whether the target was reached, and why not.
inline void conclude(const TargetCount& target, DecimateReport& report) {
  report.target_reached = !target.any() || target.is_met(report.faces, report.vertices);
  if (report.target_reached) return;
  Reasons reasons;
  reasons.add(report.held, " vertices are locked or features");
  reasons.add(report.seams, " vertices lie on seams");
  reasons.add(report.record);
  report.why = reasons.or_else("no further merge is legal, or within the planner's threshold");
}

/// The module that `decimate` adds to its sweep.
template <typename MeshT, typename Planner>
class ModDecimateT : public ModPlannedT<MeshT, Planner> {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<ModDecimateT>;
  DECIMATER_MODNAME(Decimate)

  explicit ModDecimateT(MeshT& mesh) : ModPlannedT<MeshT, Planner>(mesh) {}

  void set_options(const DecimateOptions& options, const TargetCount& target) {
    options_ = &options;
    this->set_enough(target.faces, target.vertices);
  }
  /// Fills in what the mesh held, and which charts have no face left.
  void count(bool seams_move, DecimateReport& report) {
    std::vector<std::uint32_t> left;
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (!this->mesh().status(faces_[i]).deleted()) left.push_back(static_cast<std::uint32_t>(i));
    detail::count(flags_, seams_, seams_move, left, report);
  }

 protected:
  void describe(const MeshT& mesh, const IndexedMeshT<typename MeshT::Scalar>& indexed,
                SurfaceExtras& extras) override {
    add_locks(indexed, *options_, extras.flags);
    if (options_->lock_selected)
      for (const auto v : mesh.vertices())  // without deleted ones
        if (mesh.status(v).selected()) extras.flags[static_cast<std::size_t>(v.idx())] |= kLocked;
    if (options_->weight.is_valid()) add_weights(mesh, extras.tolerance);
    add_values(mesh, options_->values, extras);
    flags_ = extras.flags;
    seams_ = SeamRecord(indexed, extras.wedges);
    faces_.clear();
    if (seams_.charts.count > 0)
      for (const auto f : mesh.faces()) faces_.push_back(f);  // without deleted ones
  }

 private:
  /// A threshold that is f times as large lets an error count 1 / f^2 as much.
  void add_weights(const MeshT& mesh, std::vector<float>& tolerance) const {
    tolerance.resize(mesh.n_vertices(), 1);
    for (const auto v : mesh.vertices()) {  // without deleted ones
      const float weight = mesh.property(options_->weight, v);
      if (!(weight > 0 && weight <= std::numeric_limits<float>::max()))
        throw InvalidParameter("vertex " + std::to_string(v.idx()) +
                               " has a weight that is not positive and finite");
      tolerance[static_cast<std::size_t>(v.idx())] /= std::sqrt(weight);
    }
  }

  const DecimateOptions* options_ = nullptr;
  std::vector<std::uint8_t> flags_;
  SeamRecord seams_;
  std::vector<typename MeshT::FaceHandle> faces_;  // of the input, if it has seams
};

}  // namespace detail

/// Simplifies an OpenMesh triangle mesh in place and compacts it.
///
/// <!-- test: header_decimate -->
/// \code
/// whittle::DecimateOptions options;
/// options.ratio = 0.1;
/// options.lock_boundary = true;
/// const whittle::DecimateReport report = whittle::decimate(mesh, options);
/// \endcode
///
/// Vertices and faces that stay keep their order, their properties and the user's own; where a vertex has moved, its
/// normal, colour and texture coordinates, those of half-edges too, are those at the nearest point of the input, and
/// face normals are computed anew. Vertices with status locked or feature stay where they are. Those on a seam of
/// half-edge texture coordinates merge along the seam with MemorylessQuadric, and both sides take the coordinates of one
/// place of it; with other planners they stay. The status properties are requested for the call and released again;
/// elements that were deleted before are removed, too. If it throws, the mesh is as it was.
/// \param planner  what decides which vertices merge; MemorylessQuadric goes to a target with the least change of shape.
/// \throw InvalidParameter  an option or a parameter outside its range, a tolerance or weight that is.
/// \throw InvalidMesh       a face is not a triangle, a coordinate is not finite.
/// \throw NotReady          nothing says where to stop.
template <typename Mesh, typename Planner = MemorylessQuadric, typename = typename Mesh::VertexHandle>
DecimateReport decimate(Mesh& mesh, const DecimateOptions& options, const Planner& planner = {}) {
  static_assert(Mesh::is_trimesh(), "whittle decimates triangle meshes");
  if (options.lock_selected && !mesh.has_vertex_status())
    throw InvalidParameter("decimate: lock_selected needs a mesh with vertex status");
  const detail::StatusesT<Mesh> statuses(mesh);
  DecimateReport report;
  const auto count = [](const auto& range) {
    return static_cast<std::size_t>(std::distance(range.begin(), range.end()));
  };
  report.faces_before = count(mesh.faces());
  report.vertices_before = count(mesh.vertices());
  const TargetCount target = detail::make_target(options, report.faces_before);

  SweepDecimaterT<Mesh> decimater(mesh);
  typename detail::ModDecimateT<Mesh, Planner>::Handle handle;
  decimater.add(handle);
  auto& module = decimater.module(handle);
  const Planner ready = detail::with_options(planner, options, target);
  module.set_planner(ready);
  module.set_options(options, target);
  module.set_tolerance(options.tolerance);
  module.set_passes(detail::passes_of<Planner>(options, target));
  module.set_threads(options.threads);
  decimater.initialize();
  if (target.any())
    decimater.decimate_to_faces(target.vertices, target.faces);
  else
    decimater.decimate();

  report.faces = decimater.report().faces;
  report.vertices = decimater.report().vertices;
  report.record = module.plan().record;
  module.count(detail::moves_seams(ready), report);
  detail::conclude(target, report);
  const std::vector<int> became = module.vertex_map();
  const Compaction compaction = compact(mesh);
  for (const int v : became)
    report.vertex_map.push_back(static_cast<std::uint32_t>(compaction.vertices[static_cast<std::size_t>(v)]));
  return report;
}

/// Simplifies points and triangles.
/// \param extras  locks and tolerances of the vertices, values, wedges; those of the options are for OpenMesh meshes.
/// \throw InvalidParameter, InvalidMesh, NotReady  as above; or an option that needs an OpenMesh mesh.
template <typename Real, typename Planner = MemorylessQuadric>
DecimatedT<Real> decimate(const IndexedMeshT<Real>& mesh, const DecimateOptions& options,
                          const Planner& planner = {}, SurfaceExtras extras = {}) {
  if (options.lock_selected || options.tolerance.is_valid() || options.weight.is_valid() ||
      options.values.any())
    throw InvalidParameter(
        "decimate: lock_selected, tolerance, weight and values are for OpenMesh meshes; give arrays in the "
        "extras");
  DecimatedT<Real> out;
  out.faces_before = mesh.triangles.size();
  out.vertices_before = mesh.points.size();
  const TargetCount target = detail::make_target(options, out.faces_before);
  const Planner ready = detail::with_options(planner, options, target);
  if (!extras.flags.empty() && extras.flags.size() != mesh.points.size())
    throw InvalidParameter("decimate: the extras must have flags for each vertex, or none");
  detail::add_locks(mesh, options, extras.flags);
  const std::vector<std::uint8_t> flags = extras.flags;
  const std::vector<std::array<std::uint32_t, 3>> wedges = extras.wedges;
  const auto enough = [&](const auto& stages) {
    return target.is_met(stages.n_faces(), stages.n_vertices());
  };
  const CollapsePlan plan =
      detail::plan_mesh(ready, mesh, std::move(extras), detail::passes_of<Planner>(options, target),
                        options.threads, enough)
          .plan;
  std::size_t n = 0;
  out.faces = out.faces_before;
  out.vertices = out.vertices_before;
  while (n < plan.collapses.size() && !target.is_met(out.faces, out.vertices)) {
    out.faces -= plan.collapses[n++].faces;
    --out.vertices;
  }
  ExecutedT<Real> executed = execute(plan, mesh, n);
  out.record = plan.record;
  out.mesh = std::move(executed.mesh);
  out.vertex_map = std::move(executed.vertex_map);
  out.face_origin = std::move(executed.face_origin);
  detail::count(flags, detail::SeamRecord(mesh, wedges), detail::moves_seams(ready), out.face_origin, out);
  detail::conclude(target, out);
  return out;
}

}  // namespace whittle
