#include "speed/json.hh"

#include <cstdio>
#include <fstream>

#include "experiment/Machine.hh"
#include "peers/peers.hh"
#include "results/Statistics.hh"
#include "speed/core.hh"

namespace whittle::speed {
namespace {

std::string hexadecimal(std::uint64_t number) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(number));
  return text;
}

/// Every time, and what it comes to.
Json times_json(const std::vector<double>& seconds) {
  if (seconds.empty()) return nullptr;
  return {{"median", bench::quantile(seconds, 0.5)},
          {"lower_quartile", bench::quantile(seconds, 0.25)},
          {"upper_quartile", bench::quantile(seconds, 0.75)},
          {"rounds", seconds}};
}

Json distance_json(const measure::Distance& distance) {
  const auto percent = [&](double units) { return 100 * units / distance.diagonal; };
  return {{"mean_units", distance.two_sided.mean},
          {"rms_percent_of_diagonal", percent(distance.two_sided.rms)},
          {"mean_percent_of_diagonal", percent(distance.two_sided.mean)},
          {"max_percent_of_diagonal", percent(distance.two_sided.max)},
          {"flipped_faces", distance.flipped_faces}};
}

Json score_json(const Score& score) {
  return {{"vertices", score.vertices},
          {"faces", score.faces},
          {"nonmanifold_edges", score.nonmanifold_edges},
          {"nonmanifold_vertices", score.nonmanifold_vertices},
          {"euler_characteristic", score.euler_characteristic},
          {"boundary_loops", score.boundary_loops},
          {"components", score.components},
          {"self_intersections", score.self_intersections ? Json(*score.self_intersections) : Json(nullptr)},
          {"distance", score.distance ? distance_json(*score.distance) : Json(nullptr)},
          {"checksum", hexadecimal(score.checksum)}};
}

Json result_json(const Result& result) {
  Json phases = Json::object();
  for (const auto& [name, seconds] : result.phase_seconds) phases[name] = times_json(seconds);
  Json memory = nullptr;
  if (result.memory) memory = {{"loaded_bytes", result.memory->loaded}, {"peak_bytes", result.memory->peak}};
  const Entry& entry = result.entry;
  return {{"name", entry.name()},
          {"method", entry.method},
          {"module", entry.module},
          {"target", entry.target},
          {"target_faces", entry.target_faces},
          {"seconds", times_json(result.seconds)},
          {"load_seconds", times_json(result.load_seconds)},
          {"unload_seconds", times_json(result.unload_seconds)},
          {"phase_seconds", phases},
          {"score", result.score ? score_json(*result.score) : Json(nullptr)},
          {"memory", memory}};
}

}  // namespace

Json run_json(unsigned threads, const std::optional<std::string>& only) {
  const auto machine = bench::machine();
  const auto core = openmesh_core();
  Json libraries = Json::object();
  for (const auto& [name, version] : peers::versions()) libraries[name] = version;
  return {{"schema", kSchema},
          {"schema_version", kSchemaVersion},
          {"date_utc", machine.date_utc},
          {"machine", {{"cpu_model", machine.cpu_model}, {"memory_bytes", machine.memory_bytes}}},
          {"build",
           {{"compiler", machine.compiler},
            {"flags", machine.flags},
            {"build_type", machine.build_type},
            {"git_commit", machine.commit},
            {"git_dirty", machine.commit_dirty}}},
          {"openmesh_core", {{"file", core.file}, {"assertions", core.assertions}, {"label", core.label}}},
          {"libraries", libraries},
          {"settings", {{"threads", threads}, {"only", only ? Json(*only) : Json(nullptr)}}},
          {"suites", Json::array()}};
}

Json suite_json(const Settings& settings, const std::vector<ModelResults>& models) {
  Json list = Json::array();
  for (const ModelResults& model : models) {
    const Subject& subject = *model.subject;
    Json results = Json::array();
    for (const Result& result : model.results) results.push_back(result_json(result));
    list.push_back({{"name", subject.name},
                    {"vertices", subject.arrays.points.size()},
                    {"faces", subject.n_faces()},
                    {"faces_refused_by_openmesh", subject.refused_faces},
                    {"mean_edge_units", subject.mean_edge},
                    {"array_bytes", subject.array_bytes()},
                    {"checksum", hexadecimal(subject.checksum)},
                    {"smooth_limit_percent_of_diagonal", model.smooth_limit},
                    {"input", model.input ? score_json(*model.input) : Json(nullptr)},
                    {"results", results}});
  }
  return {{"suite", to_string(settings.suite)},
          {"rounds", settings.rounds},
          {"samples", settings.samples},
          {"models", list}};
}

Json read_run(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path.string() + ": cannot be read");
  const Json run = Json::parse(file, nullptr, false);
  if (!run.is_object() || run.value("schema", Json()) != kSchema ||
      run.value("schema_version", Json()) != kSchemaVersion || !run.contains("suites"))
    throw std::runtime_error(path.string() + ": is no result of whittle-speed of version " +
                             std::to_string(kSchemaVersion));
  return run;
}

}  // namespace whittle::speed
