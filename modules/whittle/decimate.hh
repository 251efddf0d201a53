/// \file
/// The one call that simplifies a mesh: an OpenMesh mesh in place, with all that it carries, or plain arrays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "whittle/SweepDecimaterT.hh"
#include "whittle/compact.hh"
#include "whittle/openmesh/DecimateOptions.hh"
#include "whittle/openmesh/ModDecimateT.hh"
#include "whittle/openmesh/StatusesT.hh"
#include "whittle/openmesh/convert.hh"
#include "whittle/plan/SeamRecord.hh"
#include "whittle/plan/TargetCount.hh"
#include "whittle/plan/execute.hh"
#include "whittle/plan/plan_mesh.hh"
#include "whittle/planners/MemorylessQuadric.hh"
#include "whittle/planners/PieceChoice.hh"
#include "whittle/refit/refit.hh"
#include "whittle/surface/doubled.hh"

namespace whittle {

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
/// place of it; with other planners they stay. A mesh that has a vertex for each texture coordinate instead
/// wants `join_doubled` first. The status properties are requested for the call and released again; elements that were
/// deleted before are removed, too. If it throws, the mesh is as it was.
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
  module.set_refit(detail::wants_refit(ready, options.refit));
  module.set_threads(options.threads);
  decimater.initialize();
  if (target.any())
    decimater.decimate_to_faces(module.target().vertices, module.target().faces);
  else
    decimater.decimate();

  report.faces = decimater.report().faces;
  report.vertices = decimater.report().vertices;
  report.record = module.plan().record;
  report.refit = module.refit_report();
  report.doubled = module.n_doubled();
  module.remove_pieces(report);
  module.count(detail::moves_seams(ready), report);
  detail::conclude(target, report);
  const std::vector<int> became = module.vertex_map();
  const Compaction compaction = compact(mesh);
  for (const int v : became)
    report.vertex_map.push_back(static_cast<std::uint32_t>(compaction.vertices[static_cast<std::size_t>(v)]));
  return report;
}

namespace detail {

/// Removes the pieces that vanish as a whole from the result for a mesh.
template <typename Real>
void remove_pieces(const PieceChoice& choice, const IndexedMeshT<Real>& mesh, DecimatedT<Real>& out) {
  out.attainable = choice.attainable;
  out.pieces_gone = choice.n_gone();
  if (choice.goes.empty()) return;
  std::vector<std::uint32_t> number(out.mesh.points.size(), 0);  // of each vertex of the result, afterwards
  for (std::size_t v = 0; v < out.vertex_map.size(); ++v)
    if (choice.has_gone(v)) number[out.vertex_map[v]] = DecimateReport::kNoVertex;
  std::uint32_t n_vertices = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == DecimateReport::kNoVertex) continue;
    out.mesh.points[n_vertices] = out.mesh.points[v];
    number[v] = n_vertices++;
  }
  out.mesh.points.resize(n_vertices);
  for (std::uint32_t& v : out.vertex_map) v = number[v];
  std::size_t n_faces = 0;
  for (std::size_t f = 0; f < out.mesh.triangles.size(); ++f) {
    if (choice.has_gone(mesh.triangles[out.face_origin[f]][0])) continue;
    const auto& t = out.mesh.triangles[f];
    out.mesh.triangles[n_faces] = {number[t[0]], number[t[1]], number[t[2]]};
    out.face_origin[n_faces++] = out.face_origin[f];
  }
  out.mesh.triangles.resize(n_faces);
  out.face_origin.resize(n_faces);
  out.faces = n_faces;
  out.vertices = n_vertices;
}

}  // namespace detail

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
  extras = detail::checked(mesh, std::move(extras));
  out.doubled = detail::count_doubled(mesh);
  const bool with_refit = detail::wants_refit(ready, options.refit);
  SurfaceExtras held;
  const detail::SeamRecord seams(mesh, extras.wedges);
  const std::vector<ChartSize> kept =
      detail::keeps_charts(ready) ? chart_sizes(seams.charts, mesh.triangles) : std::vector<ChartSize>();
  const detail::PieceChoice pieces = detail::choose_pieces(ready, mesh, extras, seams, kept, options, target);
  const TargetCount way = pieces.target_with_pieces();
  if (with_refit) held = detail::held_part(extras);
  const auto enough = [&](const auto& stages) { return way.is_met(stages.n_faces(), stages.n_vertices()); };
  const CollapsePlan plan =
      detail::plan_mesh(detail::with_target(ready, way), mesh, std::move(extras),
                        detail::passes_of<Planner>(options, target), options.threads, enough)
          .plan;
  std::size_t n = 0;
  out.faces = out.faces_before;
  out.vertices = out.vertices_before;
  while (n < plan.collapses.size() && !way.is_met(out.faces, out.vertices)) {
    out.faces -= plan.collapses[n++].faces;
    --out.vertices;
  }
  ExecutedT<Real> executed = execute(plan, mesh, n);
  if (with_refit) out.refit = detail::refit_held(mesh, executed, held, options.threads);
  out.record = plan.record;
  out.mesh = std::move(executed.mesh);
  out.vertex_map = std::move(executed.vertex_map);
  out.face_origin = std::move(executed.face_origin);
  detail::remove_pieces(pieces, mesh, out);
  detail::count(flags, seams, detail::moves_seams(ready), out.face_origin, out);
  detail::conclude(target, out);
  return out;
}

}  // namespace whittle
