#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include "cli/LevelTargets.hh"
#include "cli/RecipeOptions.hh"
#include "cli/changes.hh"
#include "cli/commands.hh"
#include "cli/report.hh"
#include "files/Outputs.hh"
#include "recipe/Progression.hh"
#include "text/format.hh"
#include "text/printable.hh"

namespace whittle::cli {
namespace {

bool is_glb(const std::string& path) {
  return files::extension_of_format(path) == ".glb";
}

struct Options : RecipeOptions {
  std::string in, out, json, format, ratio_text = "0.5", faces_text;
  std::size_t levels = 5;
  LevelTargets targets;
  bool ascii = false, quiet = false, levels_given = false;
  bool one_file() const { return is_glb(format.empty() ? out : "." + format); }
};

files::WriteOptions write_options(const Options& options) {
  files::WriteOptions out;
  out.ascii = options.ascii;
  out.format = options.format;
  set_packing(options, {options.out}, out);
  return out;
}

struct Level {
  recipe::Result result;
  std::size_t wanted;  ///< faces
  measure::Distance distance;
  Json changes;  ///< of the attributes
  std::string file;
  bool target_reached() const { return result.target_reached; }
};

std::string without_extension(const std::string& path) {
  return path.substr(0, path.size() - files::whole_extension(path).size());
}

/// "out/bunny.ply" becomes "out/bunny-lod0.ply", "out/bunny-lod1.ply", and so on.
std::string file_of(const std::string& out, std::size_t level) {
  return without_extension(out) + "-lod" + std::to_string(level) +
         out.substr(out.size() - files::whole_extension(out).size());
}

/// The extension of the levels where their name has none: of the format, else the model's; of glTF that of one file.
std::string own_extension(const Options& options) {
  if (!options.format.empty()) return "." + options.format;
  const std::string of_model = files::extension_of_format(options.in);
  if (options.in == "-" || of_model.empty())
    throw recipe::RecipeError("--out has no extension, and the model none either: add one, or --format");
  return of_model == ".gltf" ? ".glb" : of_model;
}

/// Where the levels go: as it is said; into a folder under the model's name; by default beside the model, where a GLB
/// that holds all levels has another name than the model.
std::string whole_out(const Options& options) {
  namespace fs = std::filesystem;
  std::error_code error;
  std::string out = options.out;
  const bool is_folder = !out.empty() && (out.back() == '/' || fs::is_directory(out, error));
  if ((out.empty() || is_folder) && options.in == "-")
    throw recipe::RecipeError("--out NAME is required where the model comes from standard input");
  if (out.empty() || is_folder) {
    const std::string extension = own_extension(options);
    const std::string stem = without_extension(options.in);
    out = is_folder ? (fs::path(out) / fs::path(stem).filename()).string() : stem;
    if (extension == ".glb") out += "-lods";
    if (options.format.empty() && extension != ".glb")
      return out + options.in.substr(stem.size());  // packed as the model is
    return out + extension;
  }
  return files::extension_of_format(out).empty() ? out + own_extension(options) : out;
}

/// What messages call the output of a level.
std::string role_of(std::size_t level) {
  return "level " + std::to_string(level);
}

/// Tells the outputs of every file of the run.
void add_files(const Options& options, files::Outputs& outputs) {
  if (options.out == "-") throw recipe::RecipeError("--out: the levels cannot go to standard output");
  const bool one_file = options.one_file();
  for (std::size_t i = 0; i < (one_file ? 1 : options.levels); ++i)
    files::check_writable(one_file ? options.out : file_of(options.out, i), write_options(options));
  outputs.reads("MODEL", options.in);
  read_selections(options, outputs);
  if (one_file) outputs.add("--out", options.out);
  for (std::size_t i = 0; !one_file && i < options.levels; ++i)
    outputs.add(role_of(i), file_of(options.out, i));
  outputs.add("--json", options.json);
}

/// What the modules are to do for a level of so many faces.
recipe::Recipe recipe_for(const Options& options, std::size_t faces) {
  RecipeOptions with_target = options;
  with_target.faces = faces;
  return make_recipe(with_target);
}

/// mq plans once; the other modules plan each level anew, from the input.
std::vector<Level> make_levels(const Options& options, const files::MeshFile& in,
                               const std::optional<files::ImageSize>& image, const recipe::Givens& givens) {
  const bool plan_once = options.modules.empty() && options.max_distance.empty() && !options.delaunay &&
                         options.driver == "auto" && options.pieces == "keep" && !options.force;
  std::optional<recipe::Progression> progression;
  if (plan_once) progression.emplace(in.mesh, givens);
  std::vector<Level> levels;
  for (std::size_t i = 1; i < options.levels; ++i) {
    const std::size_t wanted = options.targets.faces_of(i, in.mesh.triangles.size());
    Level level{progression ? progression->at(wanted, options.refit.value_or(true))
                            : recipe::run(in.mesh, recipe_for(options, wanted), {}, givens),
                wanted,
                {},
                nullptr,
                ""};
    measure::DistanceOptions sampling;
    sampling.samples = options.samples;
    level.distance = measure::distance(in.mesh, level.result.mesh, sampling);
    if (!options.quiet || !options.json.empty()) level.changes = attribute_changes(image, in, level.result);
    levels.push_back(std::move(level));
  }
  return levels;
}

Json describe(const Options& options, const files::MeshFile& in, const std::vector<Level>& levels) {
  Json list = Json::array();
  list.push_back({{"level", 0},
                  {"vertices", in.mesh.points.size()},
                  {"faces", in.mesh.triangles.size()},
                  {"file", options.one_file() ? options.out : file_of(options.out, 0)}});
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const Level& level = levels[i];
    Json stages = Json::array();
    for (const auto& stage : level.result.stages) stages.push_back(to_json(stage));
    list.push_back({{"level", i + 1},
                    {"vertices", level.result.mesh.points.size()},
                    {"faces", level.result.mesh.triangles.size()},
                    {"faces_wanted", level.wanted},
                    {"target_reached", level.target_reached()},
                    {"flipped_faces", level.result.flipped_faces},
                    {"distance", to_json(level.distance)},
                    {"charts", charts_json(level.result)},
                    {"pieces", pieces_json(recipe_for(options, level.wanted), level.result)},
                    {"attribute_changes", level.changes},
                    {"stages", stages},
                    {"file", level.file}});
  }
  return {{"command", "lods"},
          {"input", {{"file", options.in}, {"read", to_json(in.report)}}},
          {"ratio", options.targets.step ? Json(*options.targets.step) : Json(nullptr)},
          {"levels", list}};
}

std::string table(const Options& options, const files::MeshFile& in, const std::vector<Level>& levels) {
  std::string out = text::format("%5s %10s %10s %14s %14s  %s\n", "level", "vertices", "faces",
                                 "RMS, % of box", "max, % of box", "file");
  const std::string first = options.one_file() ? options.out : file_of(options.out, 0);
  out += text::format("%5d %10zu %10zu %14s %14s  %s\n", 0, in.mesh.points.size(), in.mesh.triangles.size(),
                      "0", "0", text::printable(first).c_str());
  std::string below;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const auto& d = levels[i].distance;
    out += text::format(
        "%5zu %10zu %10zu %14s %14s  %s\n", i + 1, levels[i].result.mesh.points.size(),
        levels[i].result.mesh.triangles.size(), figure(100 * d.two_sided.rms / d.diagonal).c_str(),
        figure(100 * d.two_sided.max / d.diagonal).c_str(), text::printable(levels[i].file).c_str());
    const std::string more =
        vanished_lines(charts_json(levels[i].result),
                       pieces_json(recipe_for(options, levels[i].wanted), levels[i].result)) +
        changes_line(levels[i].changes);
    if (!more.empty()) below += text::format("level %zu:\n", i + 1) + more;
  }
  return out + below;
}

/// Which levels are no coarser than the one before: "9, 10"; empty where all are.
std::string no_coarser(const files::MeshFile& in, const std::vector<Level>& levels) {
  std::string out;
  std::size_t before = in.mesh.triangles.size();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const std::size_t faces = levels[i].result.mesh.triangles.size();
    if (faces >= before) out += (out.empty() ? "" : ", ") + std::to_string(i + 1);
    before = faces;
  }
  return out;
}

files::Parts parts_of(const files::MeshFile& in, const Level& level) {
  files::Parts parts = in.parts;
  parts.of_face = level.result.parts;
  return parts;
}

/// \return what the formats could not take.
files::WriteReport write(const Options& options, const files::MeshFile& in, std::vector<Level>& levels,
                         files::Outputs& outputs) {
  files::WriteOptions format = write_options(options);
  if (options.one_file()) {
    std::vector<files::Level> all{{in.mesh, in.attributes, in.parts, 0}};
    for (Level& level : levels) {
      all.push_back(
          {level.result.mesh, level.result.attributes, parts_of(in, level), level.distance.two_sided.max});
      level.file = options.out;
    }
    files::Encoded one = files::encode_glb_levels(options.out, all, format);
    outputs.write("--out", std::move(one.bytes));
    return std::move(one.report);
  }
  format.single_precision =
      in.single_precision || (files::writes_text(options.out, format) && files::are_texts_of_floats(in.mesh));
  format.unit = in.unit;
  format.texture_at_vertices = in.texture_at_vertices;
  format.copy_materials = options.copy_materials;
  files::Encoded model =
      files::encode_mesh(file_of(options.out, 0), in.mesh, format, in.attributes, in.parts);
  outputs.write(role_of(0), std::move(model.bytes));
  outputs.write_beside(std::move(model.companions));
  for (std::size_t i = 0; i < levels.size(); ++i) {
    levels[i].file = file_of(options.out, i + 1);
    const recipe::Result& result = levels[i].result;
    files::Encoded level =
        files::encode_mesh(levels[i].file, result.mesh, format, result.attributes, parts_of(in, levels[i]));
    outputs.write(role_of(i + 1), std::move(level.bytes));
    outputs.write_beside(std::move(level.companions));
  }
  return std::move(model.report);
}

int lods(Options options) {
  if (options.out != "-") options.out = whole_out(options);
  options.targets = parse_levels(options.ratio_text, options.faces_text);
  if (const std::size_t listed = options.targets.size(); listed > 0) {
    if (options.levels_given && options.levels != listed + 1)
      throw recipe::RecipeError("--levels " + std::to_string(options.levels) + " with a list of " +
                                std::to_string(listed) + ": the model is level 0, so there are " +
                                std::to_string(listed + 1) + " levels");
    options.levels = listed + 1;
  }
  recipe_for(options, 1);  // what is wrong with it is wrong before anything is read
  const files::WriteOptions format = write_options(options);
  files::Outputs outputs;
  add_files(options, outputs);
  files::MeshFile in = files::read_mesh(options.in, read_options(options));
  outputs.reads_beside("MODEL", in.files_beside);
  print_notes(options.in, in.report, options.quiet);
  require_faces(options.in, in);
  recipe::Givens givens = make_givens(options, in);
  const std::optional<files::ImageSize> image = files::texture_image_size(in.parts);
  std::vector<std::string> left_out = drop_attributes(options, options.out, format, in);
  give_parts(options, in, givens);
  std::vector<Level> levels = make_levels(options, in, image, givens);
  files::WriteReport written = write(options, in, levels, outputs);
  left_out.insert(left_out.end(), written.left_out.begin(), written.left_out.end());
  written.left_out = std::move(left_out);
  outputs.write("--json", json_text(describe(options, in, levels)));
  outputs.commit();
  if (!options.quiet)
    for (const std::string& note : written.notes()) complain(options.out + ": " + note);
  if (const std::string same = no_coarser(in, levels); !same.empty() && !options.quiet)
    complain("levels that have as many faces as the one before: " + same);
  const auto was_dropped = [](const Level& level) { return level.result.refit_dropped; };
  if (const auto n = std::count_if(levels.begin(), levels.end(), was_dropped); n > 0 && !options.quiet)
    complain("the refit of " + std::to_string(n) +
             " levels would break the bound on the distance and was left out");
  int code = 0;
  if (!options.quiet && options.json != "-" && !print_summary(table(options, in, levels))) code = 1;
  for (const Level& level : levels)
    if (!level.target_reached()) {
      complain("a level has " + std::to_string(level.result.mesh.triangles.size()) + " faces where " +
               std::to_string(level.wanted) + " were wanted; " +
               why_missed(recipe_for(options, level.wanted), in, level.result));
      return 1;
    }
  return code;
}

}  // namespace

Command add_lods(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("lods", "Write a chain of levels of detail, with the error of each");
  command->add_option("MODEL", options->in, "The mesh; it is level 0")->required();
  auto* levels = command->add_option("--levels", options->levels, "How many, the model included")
                     ->check(CLI::Range(std::size_t{2}, std::size_t{32}))
                     ->capture_default_str();
  auto* ratio = command
                    ->add_option("--ratio", options->ratio_text,
                                 "The faces of a level as a part of the one before, 0.01 to 0.99, or 50%; "
                                 "R,R,…: for each level as a part of the model")
                    ->capture_default_str()
                    ->type_name("R[,R...]");
  command->add_option("--faces", options->faces_text, "How many faces each level is to have, N,N,…")
      ->type_name("N[,N...]")
      ->excludes(ratio);
  command
      ->add_option(
          "--out", options->out,
          "NAME.glb: all levels in one file, with MSFT_lod; else one file each, NAME-lod0.ply and "
          "so on; without an extension in the model's format. FOLDER/: there, under the model's name. "
          "Default: beside the model, NAME-lods.glb for glTF")
      ->type_name("NAME");
  command
      ->add_option("--format", options->format,
                   "Write obj, ply, off, stl, om, glb, gltf or 3mf, whatever NAME is called")
      ->check(CLI::IsMember({"obj", "ply", "off", "stl", "om", "glb", "gltf", "3mf"}))
      ->type_name("NAME");
  add_recipe_options(*command, *options, false);
  command->add_option("--json", options->json, "Write what was done as JSON to a file, or to stdout for -");
  command->add_flag("--ascii", options->ascii, "Write PLY and STL as text");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->footer(recipe_help() +
                  "\nExamples:\n"
                  "  whittle lods bunny.obj --levels 5 --ratio 0.5 --out bunny.glb\n"
                  "  whittle lods bunny.obj --levels 4 --out lods/bunny.ply --lock boundary");
  return [options, levels] {
    options->levels_given = levels->count() > 0;
    return lods(*options);
  };
}

}  // namespace whittle::cli
