#include <nlohmann/json.hpp>

#include "experiment/Figures.hh"
#include "report/Report.hh"

namespace whittle::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchemaVersion = 1;

Json summary_json(const Summary& summary) {
  return {{"median", summary.median}, {"min", summary.min}, {"max", summary.max}};
}

Json model_json(const Report& report) {
  const Model& model = report.model;
  Json json = {{"label", model.label},
               {"kind", to_string(model.kind)},
               {"vertices", report.sets.front().facts.vertices},
               {"triangles", report.sets.front().facts.faces},
               {"mean_edge_model_units", model.mean_edge},
               {"notes", model.notes}};
  json["file"] = model.file.empty() ? Json(nullptr) : Json(model.file);
  return json;
}

Json settings_json(const Settings& settings) {
  return {{"image_width_px", settings.width},        {"image_height_px", settings.height},
          {"frames_from", settings.frames.from},     {"frames_to", settings.frames.to},
          {"frames_timed", settings.frames.timed()}, {"repetitions", settings.repetitions}};
}

Json environment_json(const Environment& environment) {
  return {{"gl_renderer", environment.gl.renderer}, {"gl_vendor", environment.gl.vendor},
          {"gl_version", environment.gl.version},   {"egl_device", environment.gl.device},
          {"cpu_model", environment.cpu_model},     {"cpu_threads", environment.cpu_threads},
          {"compiler", environment.compiler},       {"build_type", environment.build_type},
          {"git_commit", environment.commit},       {"git_dirty", environment.commit_dirty}};
}

Json repetitions_json(const SetResult& set, const Figures& figures) {
  Json list = Json::array();
  for (std::size_t i = 0; i < set.visits.size(); ++i) {
    const auto& [place, time] = set.visits[i];
    list.push_back({{"repetition", i + 1},
                    {"visited_as", place},
                    {"wall_total_ms", time.wall_ms},
                    {"gl_total_ms", time.gl_ms ? Json(*time.gl_ms) : Json(nullptr)},
                    {"improvement_percent", figures.improvement_percent[i]},
                    {"frame_time_fall_percent", figures.frame_time_fall_percent[i]}});
  }
  return list;
}

Json set_json(const SetResult& set, const Report& report) {
  const Figures f = figures(set, report.sets.front(), report.settings.frames);
  return {{"name", set.definition.name},
          {"paper_label", set.definition.paper_label},
          {"recipe", set.definition.recipe},
          {"picture", picture_name(set.definition)},
          {"picture_ears", ears_picture_name(set.definition)},
          {"vertices", set.facts.vertices},
          {"triangles", set.facts.faces},
          {"triangles_removed_percent", f.triangles_removed_percent},
          {"flipped_faces", set.flipped_faces},
          {"nonmanifold_edges", set.facts.nonmanifold_edges},
          {"wall_total_ms", summary_json(f.wall_total_ms)},
          {"gl_total_ms", f.gl_total_ms ? summary_json(*f.gl_total_ms) : Json(nullptr)},
          {"frame_mean_ms", summary_json(f.frame_mean_ms)},
          {"frames_per_second", summary_json(f.frames_per_second)},
          {"improvement_percent", summary_json(f.improvement)},
          {"frame_time_fall_percent", summary_json(f.frame_time_fall)},
          {"repetitions", repetitions_json(set, f)}};
}

}  // namespace

std::string json_text(const Report& report) {
  Json sets = Json::array();
  for (const auto& set : report.sets) sets.push_back(set_json(set, report));
  const Json json = {{"schema", "whittle-bench"},
                     {"schema_version", kSchemaVersion},
                     {"date_utc", report.environment.date_utc},
                     {"model", model_json(report)},
                     {"settings", settings_json(report.settings)},
                     {"environment", environment_json(report.environment)},
                     {"sets", sets}};
  // A file name need not be UTF-8; a replacement character is better than no results.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace whittle::bench
