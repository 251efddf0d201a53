/// \file
/// What `decimate` is told, and what it reports.
#pragma once

#include <OpenMesh/Core/Utils/Property.hh>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "whittle/openmesh/RunReport.hh"
#include "whittle/plan/CollapsePlan.hh"
#include "whittle/plan/SeamRecord.hh"
#include "whittle/plan/Stages.hh"
#include "whittle/plan/TargetCount.hh"
#include "whittle/plan/attainable.hh"
#include "whittle/plan/locks.hh"
#include "whittle/planners/PieceChoice.hh"
#include "whittle/refit/refit.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/charts.hh"
#include "whittle/surface/errors.hh"

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

  /// Pieces of the mesh, parts that share no vertex, that may vanish as a whole. Default: none.
  PieceRule pieces;
  /// Go on to the target where what cannot vanish, held vertices and small pieces, leaves the rest less than half of its
  /// share. Otherwise the target is missed, and the rest keeps its share: see `attainable`.
  bool force = false;

  /// Whether the vertices move at the end to where the faces fit the input best; see `refit`. Without a value: as the planner
  /// has it, that is with MemorylessQuadric unless there is a bound.
  std::optional<bool> refit;

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
  std::size_t pieces_gone = 0;  ///< that have vanished as a whole
  /// Vertices of the input on open edges, at exactly the place of another such: the surface is cut there and tears.
  /// `join_doubled` joins them.
  std::size_t doubled = 0;
  RefitReport refit;      ///< vertices moved at the end
  Attainable attainable;  ///< the target that was gone to, and the pieces that stay
  PlanRecord record;      ///< merges planned, and refused by flip guard, link condition and bound
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

/// The planner with a target, if it takes one and there is one.
template <typename Planner>
Planner with_target(Planner planner, const TargetCount& target) {
  if constexpr (takes_target<Planner>::value)
    if (target.any()) {
      planner.target_faces = target.faces;
      planner.target_vertices = target.vertices;
    }
  return planner;
}

/// The planner with what the options say of it.
/// \throw InvalidParameter, NotReady
template <typename Planner>
Planner with_options(Planner planner, const DecimateOptions& options, const TargetCount& target) {
  if (!(options.max_distance >= 0))
    throw InvalidParameter("decimate: max_distance must be a length of at least 0");
  options.values.validate();
  options.pieces.validate();
  if (options.pieces.by_error && !target.any())
    throw InvalidParameter(
        "decimate: pieces vanish by error on the way to a target; set ratio, faces or vertices");
  if constexpr (takes_target<Planner>::value) {
    planner = with_target(planner, target);
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

/// Whether a planner leaves each chart a face: what merges along seams does, unless it says otherwise.
template <typename Planner>
bool keeps_charts(const Planner& planner) {
  if constexpr (takes_target<Planner>::value) return planner.keep_charts;
  return moves_seams(planner);
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

/// Chooses the pieces that vanish and the target of the others, and locks those that vanish.
/// \param extras  with flags for every vertex
/// \param kept    charts of which none loses its last face
template <typename Planner, typename Real>
PieceChoice choose_pieces(const Planner& planner, const IndexedMeshT<Real>& mesh, SurfaceExtras& extras,
                          const SeamRecord& seams, const std::vector<ChartSize>& kept,
                          const DecimateOptions& options, const TargetCount& target) {
  const std::vector<std::uint8_t> flags = extras.flags;
  if (!moves_seams(planner)) seams.add_flags(extras.flags);
  PieceChoice choice = choose_pieces(mesh, extras, options.pieces, kLocked | kFeature | kSeam, kept, target,
                                     options.force, options.threads);
  extras.flags = flags;
  choice.lock(extras.flags);
  return choice;
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
  if (report.attainable.is_higher)
    reasons.add(
        report.attainable.minimum,
        " faces cannot vanish, and the rest keeps its share of the target unless DecimateOptions::force");
  reasons.add(report.attainable.small,
              " small pieces keep up to four faces each unless DecimateOptions::pieces");
  reasons.add(report.attainable.charts,
              " charts keep a face each unless DecimateOptions::keep_charts is off");
  reasons.add(report.held, " vertices are locked or features");
  reasons.add(report.seams, " vertices lie on seams");
  reasons.add(report.doubled, " vertices on open edges lie at the place of others, which join_doubled joins");
  reasons.add(report.record);
  report.why = reasons.or_else("no further merge is legal, or within the planner's threshold");
}

}  // namespace detail
}  // namespace whittle
