#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>

#include "recipe/Catalogue.hh"
#include "recipe/Spec.hh"
#include "whittle/commands.hh"
#include "whittle/report.hh"

namespace whittle::cli {
namespace {

struct Options {
  std::string in, out, json, driver = "auto";
  std::vector<std::string> modules;
  std::optional<double> ratio, delaunay;
  std::optional<std::size_t> faces, vertices;
  bool ascii = false, quiet = false;
};

recipe::Recipe make_recipe(const Options& options) {
  recipe::Recipe recipe;
  for (const std::string& text : options.modules) recipe.modules.push_back(recipe::parse_spec(text));
  recipe.target = {options.ratio, options.faces, options.vertices};
  if (recipe.modules.empty()) {
    if (!recipe.target.any())
      throw recipe::RecipeError(
          "--module is required where neither --ratio, --faces nor --vertices is given");
    recipe.modules.push_back(recipe::parse_spec("mq"));
  }
  recipe.driver = recipe::parse_driver(options.driver);
  recipe.delaunay = options.delaunay;
  recipe::check(recipe);
  return recipe;
}

Json describe(const Options& options, const files::MeshFile& in, const recipe::Result& result) {
  Json stages = Json::array();
  for (const recipe::StageResult& stage : result.stages) stages.push_back(to_json(stage));
  Json target = nullptr;
  if (options.ratio) target = {{"ratio", *options.ratio}};
  if (options.faces) target = {{"faces", *options.faces}};
  if (options.vertices) target = {{"vertices", *options.vertices}};
  Json delaunay = nullptr;
  if (options.delaunay)
    delaunay = {{"max_dihedral_degrees", *options.delaunay},
                {"edges_flipped", result.delaunay.flipped},
                {"edges_refused_by_guard", result.delaunay.refused_by_guard},
                {"edges_refused_by_topology", result.delaunay.refused_by_topology},
                {"converged", result.delaunay.converged}};
  return {{"command", "simplify"},
          {"input",
           {{"file", options.in},
            {"vertices", in.mesh.points.size()},
            {"faces", in.mesh.triangles.size()},
            {"read", to_json(in.report)}}},
          {"output",
           {{"file", options.out},
            {"vertices", result.mesh.points.size()},
            {"faces", result.mesh.triangles.size()}}},
          {"stages", stages},
          {"delaunay", delaunay},
          {"target", target},
          {"target_reached", result.target_reached},
          {"flipped_faces", result.flipped_faces},
          {"nonmanifold_faces_dropped", result.refused_faces}};
}

void print(const Options& options, const files::MeshFile& in, const recipe::Result& result) {
  const double before = static_cast<double>(in.mesh.triangles.size());
  const double after = static_cast<double>(result.mesh.triangles.size());
  double seconds = 0;
  for (const auto& stage : result.stages) seconds += stage.plan_seconds + stage.execute_seconds;
  std::printf("%s: %zu faces of %zu left (%.1f %% removed), %zu vertices, %zu flipped, %.1f ms\n",
              options.out.c_str(), result.mesh.triangles.size(), in.mesh.triangles.size(),
              before > 0 ? 100 * (1 - after / before) : 0, result.mesh.points.size(), result.flipped_faces,
              seconds * 1e3);
}

int simplify(const Options& options) {
  const recipe::Recipe recipe = make_recipe(options);
  files::check_writable(options.out);
  check_json_target(options.json);
  const files::MeshFile in = files::read_mesh(options.in);
  if (!options.quiet) print_notes(options.in, in.report);
  const recipe::Result result = recipe::run(in.mesh, recipe);
  if (result.refused_faces > 0 && !options.quiet)
    std::cerr << "whittle: " << options.in << ": " << result.refused_faces
              << " faces are not manifold and were left out; the driver bulk keeps them\n";

  files::WriteOptions format;
  format.ascii = options.ascii;
  format.single_precision = in.single_precision;
  files::write_mesh(options.out, result.mesh, format);
  write_json(options.json, describe(options, in, result));
  if (!options.quiet && options.json != "-") print(options, in, result);
  if (result.target_reached) return 0;
  std::cerr << "whittle: the target was not reached: " << result.mesh.triangles.size() << " faces and "
            << result.mesh.points.size() << " vertices are left, and no further collapse is allowed\n";
  return 1;
}

}  // namespace

Command add_simplify(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("simplify", "Simplify a mesh file");
  command->add_option("IN", options->in, "The mesh to simplify")->required();
  command->add_option("OUT", options->out, "Where the result goes; the extension says the format")
      ->required();
  command
      ->add_option("--module", options->modules,
                   "NAME[:KEY=VALUE,...]; several run one after the other. Default with a target: mq")
      ->type_name("SPEC")
      ->take_all()
      ->expected(1);
  auto* ratio = command->add_option("--ratio", options->ratio, "Keep this part of the faces, between 0 and 1")
                    ->type_name("R");
  auto* faces = command->add_option("--faces", options->faces, "Down to at most so many faces");
  auto* vertices = command->add_option("--vertices", options->vertices, "Down to at most so many vertices");
  const CLI::Validator count(
      [](std::string& text) {
        return text.empty() || text[0] == '-' || text == "0" ? "must be at least 1" : std::string();
      },
      "");
  faces->check(count)->type_name("N");
  vertices->check(count)->type_name("N");
  ratio->excludes(faces)->excludes(vertices);
  faces->excludes(vertices);
  command
      ->add_option("--delaunay", options->delaunay,
                   "Retriangulate at the end, by flips of edges no sharper than DEGREES; 20 keeps the shape")
      ->type_name("DEGREES");
  command->add_option("--driver", options->driver, "auto, bulk, sweep, lazy, decimater or mc")
      ->capture_default_str();
  command->add_option("--json", options->json, "Write what was done as JSON to a file, or to stdout for -");
  command->add_flag("--ascii", options->ascii, "Write PLY and STL as text");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->footer(
      "A LENGTH is in model units (0.0012), in mean edges (0.8e) or in percent of the bounding box's "
      "diagonal (0.5%).\n"
      "With a target and no threshold, the threshold is searched for.\n\nModules:\n" +
      recipe::catalogue_help() +
      "\nExamples:\n"
      "  whittle simplify bunny.obj small.ply --module ivdd:distance=0.0011\n"
      "  whittle simplify bunny.obj small.ply --module fad:angle=30 --module ivdd:distance=0.8e\n"
      "  whittle simplify bunny.obj half.ply --module ivdd --ratio 0.5\n"
      "  whittle simplify bunny.obj half.ply --module quadric --module normal-flipping:angle=60 --ratio 0.5");
  return [options] { return simplify(*options); };
}

}  // namespace whittle::cli
