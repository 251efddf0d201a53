/// \file
/// The refit of a simplified mesh to its original.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "whittle/plan/execute.hh"
#include "whittle/refit/Fitted.hh"
#include "whittle/refit/homes.hh"
#include "whittle/refit/solve.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/errors.hh"
#include "whittle/surface/seams.hh"
#include "whittle/surface/threads.hh"

namespace whittle {

struct RefitOptions {
  /// How often the original is compared anew with where the faces lie by then; >= 1. A third round gains another percent.
  std::size_t rounds = 2;
  /// 0: as many as the machine runs at once. The result is the same for any number.
  std::size_t threads = 0;
  /// For each vertex of the original: what merged with one that has kLocked or kFeature stays in place, what merged with one
  /// that has kSeam moves along its normal only. Or empty
  std::vector<std::uint8_t> flags;
};

/// What a refit did.
struct RefitReport {
  std::size_t moved = 0;    ///< vertices
  std::size_t refused = 0;  ///< moves in a round that would have turned a face too far
};

namespace detail {

/// The flags that hold in a refit what a plan held, and mark what moves along its normal only: what lies on seams, and all
/// vertices where values count, as the texture would slide with those that slide along the surface.
/// \param extras  as the plan had them; of the values it matters only whether there are any
template <typename Real>
std::vector<std::uint8_t> refit_flags(const IndexedMeshT<Real>& mesh, const SurfaceExtras& extras) {
  std::vector<std::uint8_t> flags = extras.flags;
  flags.resize(mesh.points.size(), 0);
  for (std::size_t v = 0; v < extras.tolerance.size(); ++v)
    if (extras.tolerance[v] == 0) flags[v] |= kLocked;
  if (extras.wedges.empty())  // where nothing says how a seam runs, it stays
    for (std::uint8_t& flag : flags)
      if ((flag & kSeam) != 0) flag |= kLocked;
  if (extras.n_values > 0) {
    for (std::uint8_t& flag : flags) flag |= kSeam;
  } else if (!extras.wedges.empty()) {
    const std::vector<bool> on_seam = on_seams(mesh.triangles, extras.wedges, mesh.points.size());
    for (std::size_t v = 0; v < flags.size(); ++v)
      if (on_seam[v]) flags[v] |= kSeam;
  }
  return flags;
}

/// Of extras what a refit looks at, before a planner takes them over.
inline SurfaceExtras held_part(const SurfaceExtras& extras) {
  SurfaceExtras part;
  part.flags = extras.flags;
  part.tolerance = extras.tolerance;
  part.wedges = extras.wedges;
  part.n_values = extras.n_values;
  return part;
}

}  // namespace detail

/// Moves the vertices of a simplified mesh to where its faces lie closest to the original, in the least squares of three
/// points of each face of the original, each taken along the original's normal. A collapse places its vertex by the faces of
/// that moment; what the collapses around it have done since, this makes up for. It needs no search: each vertex of the
/// original says around which vertex of the result its faces are to be found. Triangles and their order stay.
///
/// Vertices on the boundary, at edges that are not manifold, and those that the flags hold stay where they are, to the bit. Those
/// on seams move along their normals only, so that a seam keeps its course on the surface.
/// No vertex moves by more than a fifth of its shortest edge in a round; no face turns by more than 45 degrees in a round,
/// or over against what it was in the original.
///
/// <!-- test: header_refit -->
/// \code
/// whittle::MemorylessQuadric planner;
/// planner.target_faces = mesh.triangles.size() / 10;
/// whittle::BulkOptions options;
/// options.refit = false;  // mq's results are refitted unless told otherwise
/// auto result = whittle::bulk(planner, mesh, options);
/// whittle::refit(mesh, result);
/// \endcode
/// \param original     what `mesh` came of.
/// \param vertex_map   for each vertex of the original the one that it became; a number that `mesh` does not have: none.
/// \param face_origin  for each face the one of the original that it was.
/// \throw InvalidParameter  maps or flags of another size or with faces that are not there; no rounds.
template <typename Real>
RefitReport refit(const IndexedMeshT<Real>& original, IndexedMeshT<Real>& mesh,
                  const std::vector<std::uint32_t>& vertex_map, const std::vector<std::uint32_t>& face_origin,
                  const RefitOptions& options = {}) {
  const std::size_t n = original.points.size(), n_faces = original.triangles.size();
  if (vertex_map.size() != n || face_origin.size() != mesh.triangles.size() ||
      std::any_of(face_origin.begin(), face_origin.end(), [&](std::uint32_t f) { return f >= n_faces; }))
    throw InvalidParameter("refit: the maps do not fit: the mesh has come of another original");
  if (options.rounds == 0) throw InvalidParameter("refit: the number of rounds must be at least 1");
  if (!options.flags.empty() && options.flags.size() != n)
    throw InvalidParameter("refit: there are " + std::to_string(options.flags.size()) + " flags for " +
                           std::to_string(n) + " vertices");
  if (mesh.triangles.empty()) return {};

  using refitting::Freedom;
  std::vector<Freedom> freedom(mesh.points.size(), Freedom::any);
  for (std::size_t v = 0; v < options.flags.size(); ++v) {
    if (vertex_map[v] >= freedom.size()) continue;
    Freedom& its = freedom[vertex_map[v]];
    if ((options.flags[v] & (kLocked | kFeature)) != 0)
      its = Freedom::none;
    else if ((options.flags[v] & kSeam) != 0)
      its = std::min(its, Freedom::along_normal);
  }
  detail::Crew crew(
      std::min(detail::thread_count(options.threads), 1 + n_faces / refitting::Fitted::kAtOnce));
  const refitting::Frame<Real> frame(original.points);
  const refitting::Original input(original, frame, crew);
  refitting::Fitted fitted(mesh, frame, freedom, crew);
  const std::vector<refitting::Vec> start = fitted.points;
  std::vector<std::uint32_t> homes;
  RefitReport report;
  for (std::size_t round = 0; round < options.rounds; ++round) {
    fitted.set_faces(crew);
    if (round == 0) homes = refitting::find_homes(input, vertex_map, face_origin, fitted, crew);
    const auto sums = refitting::sums_of(input, homes, fitted, crew);
    report.refused +=
        refitting::move_all(fitted, sums, refitting::step(round, options.rounds), input, face_origin, crew);
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (fitted.points[v] == start[v]) continue;
    mesh.points[v] += frame.scale * (fitted.points[v] - start[v]).template cast<Real>();
    ++report.moved;
  }
  return report;
}

/// The same for what `execute` or `bulk` has made.
template <typename Real>
RefitReport refit(const IndexedMeshT<Real>& original, ExecutedT<Real>& result,
                  const RefitOptions& options = {}) {
  return refit(original, result.mesh, result.vertex_map, result.face_origin, options);
}

namespace detail {

/// Refits what a plan has made.
/// \param held  what it held: `held_part` of its extras
template <typename Real>
RefitReport refit_held(const IndexedMeshT<Real>& original, ExecutedT<Real>& result, const SurfaceExtras& held,
                       std::size_t threads) {
  RefitOptions options;
  options.threads = threads;
  options.flags = refit_flags(original, held);
  return refit(original, result, options);
}

}  // namespace detail
}  // namespace whittle
