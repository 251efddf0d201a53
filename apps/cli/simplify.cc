#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <utility>

#include "cli/RecipeOptions.hh"
#include "cli/changes.hh"
#include "cli/commands.hh"
#include "cli/contents.hh"
#include "cli/report.hh"
#include "files/Outputs.hh"
#include "recipe/Stopwatch.hh"
#include "recipe/run_apart.hh"
#include "text/format.hh"
#include "text/printable.hh"

namespace whittle::cli {
namespace {

struct Options : RecipeOptions {
  std::string in, out, json, map, format;
  std::string final_out;  // what `out` is going to be called; empty: the same
  bool ascii = false, quiet = false, verbose = false;
};

/// Wall-clock seconds of the parts of a run.
struct Times {
  double reading = 0;
  double planning = 0;   ///< execution and refit included
  double bounding = 0;   ///< keeping --max-distance from outside the planners
  double measuring = 0;  ///< attributes: carrying them over, and how far they have changed
  double writing = 0;
  double total() const { return reading + planning + bounding + measuring + writing; }
};

Json times_json(const Times& times) {
  return {{"reading", 1e3 * times.reading},
          {"planning", 1e3 * times.planning},
          {"bounding", 1e3 * times.bounding},
          {"measuring", 1e3 * times.measuring},
          {"writing", 1e3 * times.writing}};
}

std::string times_text(const Times& times) {
  std::string parts;
  const auto add = [&](const char* what, double seconds) {
    if (seconds > 0) parts += text::format("%s%s %.1f", parts.empty() ? "" : ", ", what, 1e3 * seconds);
  };
  add("reading", times.reading);
  add("planning", times.planning);
  add("bounding", times.bounding);
  add("measuring", times.measuring);
  add("writing", times.writing);
  return text::format("%.1f ms (", 1e3 * times.total()) + parts + ")";
}

Json target_json(const Options& options) {
  if (options.ratio) return {{"ratio", *options.ratio}};
  if (options.faces) return {{"faces", *options.faces}};
  if (options.vertices) return {{"vertices", *options.vertices}};
  return nullptr;
}

/// Where the run stopped so as not to ruin what is free.
Json raised_json(const recipe::Result& result) {
  const Attainable& attainable = result.attainable;
  if (!attainable.is_higher) return nullptr;
  const bool by_faces = attainable.target.faces > 0;
  return {{by_faces ? "faces" : "vertices", by_faces ? attainable.target.faces : attainable.target.vertices},
          {"faces_that_cannot_vanish", attainable.minimum},
          {"pieces", attainable.pieces},
          {"small_pieces", attainable.small},
          {"charts_kept", attainable.charts},
          {"vertices_held", attainable.held}};
}

Json bound_json(const recipe::Recipe& recipe, const files::MeshFile& in, const recipe::Result& result) {
  if (!recipe.max_distance) return nullptr;
  recipe::Scale scale = recipe::measure_scale(in.mesh);
  if (in.diagonal > 0) scale.diagonal = in.diagonal;
  const double percent = scale.diagonal > 0 ? 100 / scale.diagonal : 0;
  return {{"bound_units", recipe.max_distance->in(scale)},
          {"reached_units", *result.distance},
          {"reached_percent_of_diagonal", *result.distance * percent},
          {"held", result.bound_held},
          {"vertices_kept_in_place_for_it", result.held_by_bound},
          {"stopped_by_it", result.stopped_by_bound}};
}

Json delaunay_json(const Options& options, const recipe::Result& result) {
  if (!options.delaunay) return nullptr;
  return {{"max_dihedral_degrees", *options.delaunay},
          {"edges_flipped", result.delaunay.flipped},
          {"edges_refused_by_guard", result.delaunay.refused_by_guard},
          {"edges_refused_by_topology", result.delaunay.refused_by_topology},
          {"converged", result.delaunay.converged},
          {"dropped_for_the_bound", result.retriangulation_dropped}};
}

Json refit_json(const recipe::Result& result) {
  if (!result.refit && !result.refit_dropped) return nullptr;
  const RefitReport refit = result.refit.value_or(RefitReport());
  return {{"vertices_moved", refit.moved},
          {"moves_refused", refit.refused},
          {"ms", 1e3 * result.refit_seconds},
          {"dropped_for_the_bound", result.refit_dropped}};
}

Json names(const attributes::Attributes& attributes) {
  Json out = Json::array();
  for (const auto& attribute : attributes) out.push_back(attributes::to_string(attribute));
  return out;
}

Json paths_of(const std::set<std::filesystem::path>& files) {
  Json out = Json::array();
  for (const std::filesystem::path& file : files) out.push_back(file.string());
  return out;
}

/// What is said of the run besides what the files could not hold.
std::vector<std::string> notes_on(const recipe::Result& result) {
  std::vector<std::string> notes;
  if (result.refused_faces > 0)
    notes.push_back(std::to_string(result.refused_faces) +
                    " faces are not manifold and were left out; the driver bulk keeps them");
  if (result.refit_dropped)
    notes.emplace_back("the refit would break the bound on the distance and was left out");
  if (result.retriangulation_dropped)
    notes.emplace_back("the Delaunay retriangulation would break the bound on the distance and was left out");
  return notes;
}

/// All lines on what was read, changed and left out.
Json notes_json(const files::ReadReport& read, const files::WriteReport& written,
                const recipe::Result& result) {
  Json out = Json::array();
  for (const auto& notes : {read.notes(), notes_on(result), written.notes()})
    for (const std::string& note : notes) out.push_back(note);
  return out;
}

Json describe(const Options& options, const recipe::Recipe& recipe, const files::MeshFile& in,
              const Json& attributes_read, const Json& changes, const recipe::Result& result,
              const files::WriteReport& written, const Json& companions, const Times& times) {
  Json stages = Json::array();
  for (const recipe::StageResult& stage : result.stages) stages.push_back(to_json(stage));
  return {{"command", "simplify"},
          {"input",
           {{"file", options.in},
            {"vertices", in.mesh.points.size()},
            {"faces", in.mesh.triangles.size()},
            {"attributes", attributes_read},
            {"files_beside", paths_of(in.files_beside)},
            {"read", to_json(in.report)}}},
          {"output",
           {{"file", options.out},
            {"vertices", result.mesh.points.size()},
            {"faces", result.mesh.triangles.size()},
            {"vertices_doubled", written.doubled_vertices},
            {"attributes_left_out", written.left_out},
            {"materials", materials_json(in.parts)},
            {"files_beside", companions},
            {"reduced", written.reduced}}},
          {"notes", notes_json(in.report, written, result)},
          {"attributes_dropped", options.drop},
          {"attribute_changes", changes},
          {"locks", options.locks},
          {"vertices_locked", result.held - result.held_on_seams},
          {"vertices_held_on_seams", result.held_on_seams},
          {"charts", charts_json(result)},
          {"pieces", pieces_json(recipe, result)},
          {"weights", options.weights.empty() ? Json(nullptr) : Json(options.weights)},
          {"stages", stages},
          {"refit", refit_json(result)},
          {"delaunay", delaunay_json(options, result)},
          {"target", target_json(options)},
          {"target_reached", result.target_reached},
          {"target_raised", raised_json(result)},
          {"target_missed_because", missed_because(recipe, in, result)},
          {"max_distance", bound_json(recipe, in, result)},
          {"flipped_faces", result.flipped_faces},
          {"nonmanifold_faces_dropped", result.refused_faces},
          {"ms", times_json(times)}};
}

std::string summary(const Options& options, const recipe::Recipe& recipe, const files::MeshFile& in,
                    const Json& changes, const recipe::Result& result, const std::string& materials,
                    const Json& companions, const Times& times) {
  const double before = static_cast<double>(in.mesh.triangles.size());
  const double after = static_cast<double>(result.mesh.triangles.size());
  std::string out =
      text::format("%s: %zu faces of %zu left (%.1f %% removed), %zu vertices, %zu flipped, %s\n",
                   text::printable(options.out).c_str(), result.mesh.triangles.size(),
                   in.mesh.triangles.size(), before > 0 ? 100 * (1 - after / before) : 0,
                   result.mesh.points.size(), result.flipped_faces, times_text(times).c_str());
  out += vanished_lines(charts_json(result), pieces_json(recipe, result));
  if (!materials.empty()) out += "  " + text::printable(materials) + "\n";
  out += beside_line(companions);
  if (result.distance) out += text::format("  distance to the input: %s\n", figure(*result.distance).c_str());
  out += changes_line(changes);
  if (!options.verbose) return out;
  for (const auto& stage : result.stages) {
    out += text::format("  %s: %zu to %zu faces, driver %s, %zu passes, plan %.1f ms, execute %.1f ms\n",
                        stage.module.c_str(), stage.faces_before, stage.faces_after,
                        recipe::to_string(stage.driver).c_str(), stage.passes, stage.plan_seconds * 1e3,
                        stage.execute_seconds * 1e3);
    out += text::format(
        "    refused: %zu by the flip guard, %zu by the link condition, %zu by seams, %zu by the driver\n",
        stage.record.refused_by_flip_guard, stage.record.refused_by_link, stage.record.refused_by_seam,
        stage.refused_by_decimater);
  }
  if (result.refit)
    out += text::format("  refit: %zu vertices moved, %zu moves refused, %.1f ms\n", result.refit->moved,
                        result.refit->refused, result.refit_seconds * 1e3);
  if (result.held > result.held_on_seams)
    out += text::format("  %zu vertices locked\n", result.held - result.held_on_seams);
  if (result.held_on_seams > 0) out += text::format("  %zu vertices on seams held\n", result.held_on_seams);
  if (result.held_by_bound > 0)
    out += text::format("  %zu vertices kept in place for the bound's sake\n", result.held_by_bound);
  return out;
}

/// Line v holds the vertex of OUT that vertex v of IN became; both count from 0, as the files have them. -1: its piece
/// has vanished, or it was of no face and the repair has left it out.
std::string map_text(const files::MeshFile& in, const recipe::Result& result,
                     const files::WriteReport& written) {
  std::string text;
  const auto add = [&](std::uint32_t w) {
    if (w == recipe::Result::kNoVertex)
      text += "-1\n";
    else
      text += std::to_string(written.first_vertex.empty() ? w : written.first_vertex[w]) + "\n";
  };
  if (in.vertex_of.empty())
    for (const std::uint32_t w : result.vertex_map) add(w);
  for (const std::uint32_t v : in.vertex_of)
    add(v == files::MeshFile::left_out ? recipe::Result::kNoVertex : result.vertex_map[v]);
  return text;
}

void warn(const Options& options, const recipe::Result& result, const files::WriteReport& written) {
  for (const std::string& line : options.quiet ? written.lost_files : written.notes())
    complain(options.out + ": " + line);
  if (options.quiet) return;
  for (const std::string& note : notes_on(result)) complain(options.in + ": " + note);
}

int complain_about_misses(const recipe::Recipe& recipe, const files::MeshFile& in,
                          const recipe::Result& result) {
  int code = 0;
  if (!result.bound_held) {
    complain("the bound on the distance could not be kept: " + figure(*result.distance) +
             " units; faces that OpenMesh cannot take are missing");
    code = 1;
  }
  if (!result.target_reached) {
    complain("the target was not reached: " + std::to_string(result.mesh.triangles.size()) + " faces and " +
             std::to_string(result.mesh.points.size()) + " vertices are left; " +
             why_missed(recipe, in, result));
    code = 1;
  }
  return code;
}

int simplify(const Options& options) {
  const recipe::Recipe recipe = make_recipe(options);
  files::WriteOptions format;
  format.ascii = options.ascii;
  format.format = options.format;
  files::check_writable(options.out, format);
  set_packing(options, {options.out}, format);
  files::Outputs outputs;
  outputs.reads("IN", options.in);
  read_selections(options, outputs);
  outputs.add("OUT", options.out, "IN");
  outputs.add("--map", options.map);
  outputs.add("--json", options.json);

  Times times;
  recipe::Stopwatch watch;
  files::ReadOptions reading = read_options(options);
  reading.keep_scene = !options.flatten && files::holds_scenes(options.out, format);
  files::MeshFile in = files::read_mesh(options.in, reading);
  outputs.reads_beside("IN", in.files_beside);
  times.reading = watch.lap();
  print_notes(options.in, in.report, options.quiet);
  if (recipe.target.any()) require_faces(options.in, in);
  const Json attributes_read = names(in.attributes);
  const bool digits_of_floats =
      !in.single_precision && files::writes_text(options.out, format) && files::are_texts_of_floats(in.mesh);
  recipe::Givens givens = make_givens(options, in);
  const std::optional<files::ImageSize> image = files::texture_image_size(in.parts);
  std::vector<std::string> left_out = drop_attributes(options, options.out, format, in);
  give_parts(options, in, givens);
  if (options.each_mesh && !in.scene)
    throw recipe::RecipeError("--each-mesh is for scenes, from glTF to glTF without --flatten");
  const recipe::Result result =
      options.each_mesh ? recipe::run_apart(in.mesh, files::meshes_of_faces(in), recipe, {}, givens)
                        : recipe::run(in.mesh, recipe, {}, givens);
  times.planning = result.seconds();
  (recipe.max_distance ? times.bounding : times.measuring) = std::max(0.0, watch.lap() - times.planning);
  const bool is_told = !options.quiet || !options.json.empty();
  const Json changes = is_told ? attribute_changes(image, in, result) : Json(nullptr);
  times.measuring += watch.lap();

  format.single_precision = in.single_precision || digits_of_floats;
  format.unit = in.unit;
  format.texture_at_vertices = in.texture_at_vertices;
  format.copy_materials = options.copy_materials;
  in.parts.of_face = result.parts;
  const std::string& name = options.final_out.empty() ? options.out : options.final_out;
  files::Encoded out =
      in.scene ? files::encode_scene(
                     name, in, {result.mesh, result.attributes, result.parts, result.vertex_map}, format)
               : files::encode_mesh(name, result.mesh, format, result.attributes, in.parts);
  left_out.insert(left_out.end(), out.report.left_out.begin(), out.report.left_out.end());
  out.report.left_out = std::move(left_out);
  const Json companions = names_of(out.companions);
  outputs.write("OUT", std::move(out.bytes));
  outputs.write_beside(std::move(out.companions));
  times.writing = watch.lap();
  outputs.write("--map", map_text(in, result, out.report));
  outputs.write("--json", json_text(describe(options, recipe, in, attributes_read, changes, result,
                                             out.report, companions, times)));
  outputs.commit();
  times.writing += watch.lap();
  warn(options, result, out.report);
  int code = complain_about_misses(recipe, in, result);
  const bool stdout_is_taken = options.out == "-" || options.map == "-" || options.json == "-";
  if (!options.quiet && !stdout_is_taken &&
      !print_summary(summary(options, recipe, in, changes, result, out.report.materials, companions, times)))
    code = 1;
  return code;
}

}  // namespace

Command add_simplify(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("simplify", "Simplify a mesh file");
  command->add_option("IN", options->in, "The mesh to simplify; - is standard input")->required();
  command
      ->add_option("OUT", options->out,
                   "Where the result goes; the extension says the format; - is standard output")
      ->required();
  add_recipe_options(*command, *options, true);
  command
      ->add_option("--format", options->format,
                   "Write obj, ply, off, stl, om, glb, gltf or 3mf, whatever OUT is called")
      ->type_name("NAME");
  command->add_option("--json", options->json, "Write what was done as JSON to a file, or to stdout for -");
  command->add_option(
      "--map", options->map,
      "Write a line for each vertex of the input, which vertex it became, to a file, or to stdout for -");
  command
      ->add_option(
          "--final-out", options->final_out,
          "Where OUT is moved to afterwards: what is written beside it goes there, and what it refers to is "
          "named from there")
      ->check(CLI::Validator(
          [](const std::string& path) { return path.empty() ? std::string("an empty path") : ""; }, ""))
      ->type_name("PATH");
  command->add_flag("--ascii", options->ascii, "Write PLY and STL as text");
  auto* quiet = command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->add_flag("--verbose", options->verbose, "Print what each stage did")->excludes(quiet);
  command->footer(
      recipe_help() +
      "\nExamples:\n"
      "  whittle simplify bunny.obj small.ply --ratio 0.1\n"
      "  whittle simplify bunny.obj small.ply --module ivdd:distance=0.0011\n"
      "  whittle simplify bunny.obj small.ply --module fad:angle=30 --module ivdd:distance=0.8e\n"
      "  whittle simplify bunny.obj half.ply --module ivdd --ratio 0.5\n"
      "  whittle simplify scan.ply small.ply --max-distance 0.1% --lock boundary --lock feature:40\n"
      "  whittle simplify bunny.obj half.ply --module quadric --module normal-flipping:angle=60 --ratio 0.5\n"
      "  zcat scan.ply.gz | whittle simplify - - --format glb --faces 20000 > small.glb");
  return [options] { return simplify(*options); };
}

}  // namespace whittle::cli
