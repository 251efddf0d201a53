#include "figures/json.hh"

namespace whittle::figures {
namespace {

Json deviation(const measure::Deviation& d, double diagonal) {
  const double percent = diagonal > 0 ? 100 / diagonal : 0;
  return {{"rms_units", d.rms},
          {"mean_units", d.mean},
          {"max_units", d.max},
          {"rms_percent_of_diagonal", d.rms * percent},
          {"mean_percent_of_diagonal", d.mean * percent},
          {"max_percent_of_diagonal", d.max * percent},
          {"samples", d.samples}};
}

Json point(const Eigen::Vector3d& p) {
  return {p[0], p[1], p[2]};
}

}  // namespace

Json to_json(const measure::MeshFacts& f) {
  return {{"vertices", f.vertices},
          {"faces", f.faces},
          {"edges", f.edges},
          {"boundary_edges", f.boundary_edges},
          {"boundary_loops", f.boundary_loops},
          {"nonmanifold_edges", f.nonmanifold_edges},
          {"nonmanifold_vertices", f.nonmanifold_vertices},
          {"isolated_vertices", f.isolated_vertices},
          {"degenerate_faces", f.degenerate_faces},
          {"duplicate_faces", f.duplicate_faces},
          {"components", f.components},
          {"euler_characteristic", f.euler_characteristic},
          {"closed", f.closed()},
          {"area_square_units", f.area},
          {"volume_cubic_units", f.volume},
          {"mean_edge_units", f.mean_edge},
          {"min_edge_units", f.min_edge},
          {"max_edge_units", f.max_edge},
          {"diagonal_units", f.diagonal},
          {"box_min_units", point(f.box_min)},
          {"box_max_units", point(f.box_max)}};
}

Json to_json(const measure::Distance& d) {
  return {{"two_sided", deviation(d.two_sided, d.diagonal)},
          {"original_to_simplified", deviation(d.forward, d.diagonal)},
          {"simplified_to_original", deviation(d.backward, d.diagonal)},
          {"diagonal_units", d.diagonal},
          {"flipped_faces_against_nearest", d.flipped_faces}};
}

Json to_json(const measure::CertifiedDistance& d, double diagonal) {
  return {{"lower_units", d.lower},
          {"upper_units", d.upper},
          {"lower_percent_of_diagonal", 100 * d.lower / diagonal},
          {"upper_percent_of_diagonal", 100 * d.upper / diagonal},
          {"farthest_units", point(d.farthest)},
          {"farthest_on", d.on_original ? "original" : "simplified"},
          {"pieces", d.pieces}};
}

Json to_json(const Intersections& i, bool list) {
  Json out = {{"pairs", i.pairs.size()}, {"all", i.complete}};
  if (list) out["list"] = i.pairs;
  return out;
}

Json to_json(const attributes::TextureError& e, double texels) {
  return {{"rms_texels", e.rms},  {"max_texels", e.max}, {"texels_across", texels},
          {"samples", e.samples}, {"charts", e.charts},  {"charts_left", e.charts_left}};
}

Json to_json(const recipe::StageResult& s) {
  return {{"module", s.module},
          {"driver", recipe::to_string(s.driver)},
          {"passes", s.passes},
          {"faces_before", s.faces_before},
          {"faces_after", s.faces_after},
          {"collapses", s.collapses},
          {"clusters_planned", s.record.planned},
          {"clusters_refused_by_flip_guard", s.record.refused_by_flip_guard},
          {"clusters_refused_by_link_condition", s.record.refused_by_link},
          {"clusters_refused_by_seams", s.record.refused_by_seam},
          {"clusters_fallen_back", s.record.fell_back},
          {"collapses_refused_by_driver", s.refused_by_decimater},
          {"plan_ms", s.plan_seconds * 1e3},
          {"execute_ms", s.execute_seconds * 1e3}};
}

Json to_json(const files::ReadReport& r) {
  std::vector<std::string> ignored = r.ignored;
  ignored.insert(ignored.end(), r.ignored_besides.begin(), r.ignored_besides.end());
  return {{"format", r.format},
          {"polygons_split", r.polygons},
          {"polygons_concave", r.concave_polygons},
          {"polygons_crossing", r.crossing_polygons},
          {"polygons_flat", r.flat_polygons},
          {"overlong_lines", r.overlong_lines},
          {"wrong_count", r.wrong_count.empty() ? Json(nullptr) : Json(r.wrong_count)},
          {"degenerate_faces_dropped", r.dropped_degenerate},
          {"vertices_merged", r.merged_vertices},
          {"vertices_left_apart", r.vertices_apart},
          {"edges_left_open", r.edges_left_open},
          {"lone_faces", r.lone_faces},
          {"parts_joined", r.parts},
          {"values_missing", r.missing_values},
          {"values_not_finite", r.zeroed_values},
          {"repair", files::to_string(r.repair)},
          {"broken_faces_dropped", r.broken_faces},
          {"duplicate_faces", r.duplicate_faces},
          {"nonmanifold_edges", r.nonmanifold_edges},
          {"nonmanifold_vertices", r.nonmanifold_vertices},
          {"faces_turned", r.turned_faces},
          {"vertices_copied", r.copied_vertices},
          {"vertices_dropped", r.dropped_vertices},
          {"attributes_rounded", r.rounded},
          {"attributes_ignored", ignored},
          {"files_not_found", r.not_found},
          {"files_refused", r.refused}};
}

}  // namespace whittle::figures
