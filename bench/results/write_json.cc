#include <nlohmann/json.hpp>

#include "results/Figures.hh"
#include "results/json.hh"
#include "results/names.hh"

namespace whittle::bench {
namespace {

using Json = nlohmann::ordered_json;

template <typename Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

Json summary_json(const Summary& s) {
  return {{"median", s.median}, {"min", s.min}, {"max", s.max}};
}

Json fidelity_json(const Fidelity& f) {
  return {{"rms_model_units", f.rms},
          {"mean_model_units", f.mean},
          {"max_model_units", f.max},
          {"normal_deviation_mean_degrees", f.normal_mean_degrees},
          {"normal_deviation_max_degrees", f.normal_max_degrees},
          {"quality_mean", f.quality_mean},
          {"quality_p05", f.quality_p05},
          {"psnr_db", f.psnr_db},
          {"psnr_worst_db", f.psnr_worst_db},
          {"ssim", f.ssim},
          {"ssim_worst", f.ssim_worst}};
}

Json figures_json(const Figures& f) {
  return {{"triangles_removed_percent", f.triangles_removed_percent},
          {"wall_total_ms", summary_json(f.wall_total_ms)},
          {"gl_total_ms", f.gl_total_ms ? summary_json(*f.gl_total_ms) : Json(nullptr)},
          {"frame_mean_ms", summary_json(f.frame_mean_ms)},
          {"frames_per_second", summary_json(f.frames_per_second)},
          {"frames_per_second_gained", summary_json(f.frames_per_second_gained)},
          {"improvement_percent", summary_json(f.improvement)},
          {"frame_time_fall_percent", summary_json(f.frame_time_fall)},
          {"certainty", to_string(f.certainty)}};
}

Json set_json(const SetResult& set, const ExperimentResult& experiment) {
  const SetDefinition& d = set.definition;
  Json times = Json::array();
  for (const Visit& visit : set.visits)
    times.push_back({{"repetition", visit.repetition},
                     {"start", visit.start},
                     {"visited_as", visit.visited_as},
                     {"wall_total_ms", visit.wall_ms},
                     {"gl_total_ms", or_null(visit.gl_ms)}});
  const auto f = figures(set, experiment);
  return {{"name", d.name},
          {"label", d.label},
          {"role", to_string(d.role)},
          {"algorithm", text_or_null(d.algorithm)},
          {"parameter", text_or_null(d.parameter)},
          {"recipe", d.recipe},
          {"compared_with", text_or_null(d.compared_with)},
          {"made", set.made},
          {"vertices", set.vertices},
          {"triangles", set.triangles},
          {"flipped_faces", set.flipped_faces},
          {"nonmanifold_edges", set.nonmanifold_edges},
          {"decimation_ms", set.decimation_ms},
          {"cache_misses_per_triangle", set.cache_misses_per_triangle},
          {"fidelity", set.fidelity ? fidelity_json(*set.fidelity) : Json(nullptr)},
          {"pictures",
           {{"whole", text_or_null(set.pictures.whole)},
            {"detail", text_or_null(set.pictures.detail)},
            {"heat", text_or_null(set.pictures.heat)}}},
          {"note", text_or_null(set.note)},
          {"times", times},
          {"figures", f ? figures_json(*f) : Json(nullptr)}};
}

Json experiment_json(const ExperimentResult& e) {
  Json sets = Json::array();
  for (const SetResult& set : e.sets) sets.push_back(set_json(set, e));
  return {{"name", e.name},
          {"model",
           {{"label", e.model.label},
            {"kind", e.model.kind},
            {"file", text_or_null(e.model.file)},
            {"vertices", e.model.vertices},
            {"triangles", e.model.triangles},
            {"mean_edge_model_units", e.model.mean_edge},
            {"diagonal_model_units", e.model.diagonal},
            {"notes", e.model.notes}}},
          {"frames_from", e.timing.frames_from},
          {"frames_to", e.timing.frames_to},
          {"repetitions", e.timing.repetitions},
          {"heat_scale_model_units", e.heat_scale},
          {"sets", sets}};
}

Json environment_json(const Environment& e) {
  return {{"gl_renderer", e.gl_renderer}, {"gl_vendor", e.gl_vendor},   {"gl_version", e.gl_version},
          {"egl_device", e.egl_device},   {"cpu_model", e.cpu_model},   {"cpu_threads", e.cpu_threads},
          {"compiler", e.compiler},       {"build_type", e.build_type}, {"git_commit", e.commit},
          {"git_dirty", e.commit_dirty},  {"date_utc", e.date_utc}};
}

}  // namespace

std::string json_text(const Results& results) {
  Json experiments = Json::array();
  for (const auto& experiment : results.experiments) experiments.push_back(experiment_json(experiment));
  const Json json = {{"schema", kSchema},
                     {"schema_version", kSchemaVersion},
                     {"protocol", results.protocol},
                     {"complete", results.complete},
                     {"starts", results.starts},
                     {"settings",
                      {{"image_width_px", results.settings.width},
                       {"image_height_px", results.settings.height},
                       {"views", results.settings.views},
                       {"samples_per_side", results.settings.samples}}},
                     {"environment", environment_json(results.environment)},
                     {"notes", results.notes},
                     {"experiments", experiments}};
  // A file name need not be UTF-8; a replacement character is better than no results.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace whittle::bench
