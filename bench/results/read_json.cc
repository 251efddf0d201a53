#include <cmath>
#include <nlohmann/json.hpp>

#include "results/json.hh"
#include "results/names.hh"

namespace whittle::bench {
namespace {

using Json = nlohmann::ordered_json;

/// An object of the file, and where it stands, for messages.
class Field {
 public:
  Field(const Json& json, std::string place) : json_(json), place_(std::move(place)) {
    if (!json.is_object()) throw ResultsError(place_ + " is not an object");
  }

  const Json& raw(const char* key) const {
    const auto found = json_.find(key);
    if (found == json_.end()) throw ResultsError(place_ + " has no field \"" + key + "\"");
    return *found;
  }
  Field object(const char* key) const { return {raw(key), place_ + "." + key}; }

  template <typename Value>
  void get(const char* key, Value& value) const {
    const Json& field = raw(key);
    // Counts must be counts: the library would turn -1 and 0.5 into them.
    if constexpr (std::is_unsigned_v<Value> && !std::is_same_v<Value, bool>)
      if (!field.is_number_unsigned()) throw ResultsError(place_ + "." + key + " is not a count");
    try {
      field.get_to(value);
    } catch (const Json::exception&) {
      throw ResultsError(place_ + "." + key + " has the wrong type");
    }
  }
  /// Null leaves the text empty.
  void get_text(const char* key, std::string& text) const {
    if (!raw(key).is_null()) get(key, text);
  }

  template <typename Visitor>
  void each(const char* key, Visitor visit) const {
    const Json& list = raw(key);
    if (!list.is_array()) throw ResultsError(place_ + "." + key + " is not a list");
    for (std::size_t i = 0; i < list.size(); ++i)
      visit(Field(list[i], place_ + "." + key + "[" + std::to_string(i) + "]"));
  }

  [[noreturn]] void fail(const std::string& what) const { throw ResultsError(place_ + ": " + what); }

 private:
  const Json& json_;
  std::string place_;
};

Role parse_role(const Field& field) {
  std::string name;
  field.get("role", name);
  for (const Role role : {Role::paper, Role::literal, Role::curve, Role::peer, Role::cache})
    if (to_string(role) == name) return role;
  field.fail("unknown role \"" + name + "\"");
}

Visit read_visit(const Field& field) {
  Visit visit;
  field.get("repetition", visit.repetition);
  field.get("start", visit.start);
  field.get("visited_as", visit.visited_as);
  field.get("wall_total_ms", visit.wall_ms);
  if (!(visit.wall_ms > 0)) field.fail("wall_total_ms must be positive");
  if (!field.raw("gl_total_ms").is_null()) field.get("gl_total_ms", visit.gl_ms.emplace());
  return visit;
}

Fidelity read_fidelity(const Field& field) {
  Fidelity f;
  field.get("rms_model_units", f.rms);
  field.get("mean_model_units", f.mean);
  field.get("max_model_units", f.max);
  field.get("normal_deviation_mean_degrees", f.normal_mean_degrees);
  field.get("normal_deviation_max_degrees", f.normal_max_degrees);
  field.get("quality_mean", f.quality_mean);
  field.get("quality_p05", f.quality_p05);
  field.get("psnr_db", f.psnr_db);
  field.get("psnr_worst_db", f.psnr_worst_db);
  field.get("ssim", f.ssim);
  field.get("ssim_worst", f.ssim_worst);
  return f;
}

SetResult read_set(const Field& field) {
  SetResult set;
  SetDefinition& d = set.definition;
  field.get("name", d.name);
  field.get("label", d.label);
  d.role = parse_role(field);
  field.get_text("algorithm", d.algorithm);
  field.get_text("parameter", d.parameter);
  field.get("recipe", d.recipe);
  field.get_text("compared_with", d.compared_with);
  field.get("made", set.made);
  field.get("vertices", set.vertices);
  field.get("triangles", set.triangles);
  field.get("flipped_faces", set.flipped_faces);
  field.get("nonmanifold_edges", set.nonmanifold_edges);
  field.get("decimation_ms", set.decimation_ms);
  field.get("cache_misses_per_triangle", set.cache_misses_per_triangle);
  if (!field.raw("fidelity").is_null()) set.fidelity = read_fidelity(field.object("fidelity"));
  const Field pictures = field.object("pictures");
  pictures.get_text("whole", set.pictures.whole);
  pictures.get_text("detail", set.pictures.detail);
  pictures.get_text("heat", set.pictures.heat);
  field.get_text("note", set.note);
  field.each("times", [&](const Field& time) { set.visits.push_back(read_visit(time)); });
  return set;
}

ExperimentResult read_experiment(const Field& field) {
  ExperimentResult e;
  field.get("name", e.name);
  const Field model = field.object("model");
  model.get("label", e.model.label);
  model.get("kind", e.model.kind);
  model.get_text("file", e.model.file);
  model.get("vertices", e.model.vertices);
  model.get("triangles", e.model.triangles);
  model.get("mean_edge_model_units", e.model.mean_edge);
  model.get("diagonal_model_units", e.model.diagonal);
  model.get("notes", e.model.notes);
  field.get("frames_from", e.timing.frames_from);
  field.get("frames_to", e.timing.frames_to);
  field.get("repetitions", e.timing.repetitions);
  if (e.timing.frames_to <= e.timing.frames_from) field.fail("frames_to must be above frames_from");
  field.get("heat_scale_model_units", e.heat_scale);
  field.each("sets", [&](const Field& set) { e.sets.push_back(read_set(set)); });
  if (e.sets.empty() || !e.sets.front().definition.original())
    field.fail("the first set is not the original");
  return e;
}

Environment read_environment(const Field& field) {
  Environment e;
  field.get("gl_renderer", e.gl_renderer);
  field.get("gl_vendor", e.gl_vendor);
  field.get("gl_version", e.gl_version);
  field.get("egl_device", e.egl_device);
  field.get("cpu_model", e.cpu_model);
  field.get("cpu_threads", e.cpu_threads);
  field.get("compiler", e.compiler);
  field.get("build_type", e.build_type);
  field.get("git_commit", e.commit);
  field.get("git_dirty", e.commit_dirty);
  field.get("date_utc", e.date_utc);
  return e;
}

}  // namespace

Results parse_results(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) throw ResultsError("not JSON, or cut off");
  const Field root(json, "the file");
  std::string schema;
  root.get("schema", schema);
  if (schema != kSchema) root.fail("the schema is not \"" + std::string(kSchema) + "\"");
  int version = 0;
  root.get("schema_version", version);
  if (version != kSchemaVersion)
    root.fail("schema version " + std::to_string(version) + "; this program reads version " +
              std::to_string(kSchemaVersion));
  Results results;
  root.get("protocol", results.protocol);
  root.get("complete", results.complete);
  root.get("starts", results.starts);
  root.get("notes", results.notes);
  const Field settings = root.object("settings");
  settings.get("image_width_px", results.settings.width);
  settings.get("image_height_px", results.settings.height);
  settings.get("views", results.settings.views);
  settings.get("samples_per_side", results.settings.samples);
  results.environment = read_environment(root.object("environment"));
  root.each("experiments", [&](const Field& e) { results.experiments.push_back(read_experiment(e)); });
  return results;
}

}  // namespace whittle::bench
