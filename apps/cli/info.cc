#include <cstdio>
#include <memory>

#include "cli/commands.hh"
#include "cli/report.hh"

namespace whittle::cli {
namespace {

void print(const std::string& path, const std::string& format, const measure::MeshFacts& f) {
  const auto count = [](const char* name, std::size_t n) { std::printf("  %-22s %zu\n", name, n); };
  const auto size = [](const char* name, double x) { std::printf("  %-22s %s\n", name, figure(x).c_str()); };
  std::printf("%s (%s)\n", path.c_str(), format.c_str());
  count("vertices", f.vertices);
  count("faces", f.faces);
  count("edges", f.edges);
  count("components", f.components);
  std::printf("  %-22s %ld\n", "Euler characteristic", f.euler_characteristic);
  count("boundary edges", f.boundary_edges);
  count("boundary loops", f.boundary_loops);
  count("non-manifold edges", f.nonmanifold_edges);
  count("non-manifold vertices", f.nonmanifold_vertices);
  count("isolated vertices", f.isolated_vertices);
  count("degenerate faces", f.degenerate_faces);
  count("duplicate faces", f.duplicate_faces);
  size("area", f.area);
  size("volume", f.volume);
  size("mean edge", f.mean_edge);
  size("shortest edge", f.min_edge);
  size("longest edge", f.max_edge);
  size("box diagonal", f.diagonal);
}

}  // namespace

Command add_info(CLI::App& app) {
  struct Options {
    std::string mesh, json;
    bool quiet = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("info", "Tell what is in a mesh file");
  command->add_option("MESH", options->mesh, "The mesh file")->required();
  command->add_option("--json", options->json, "Write the figures as JSON to a file, or to stdout for -");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->footer("Example:\n  whittle info bunny.ply");
  return [options] {
    check_json_target(options->json);
    const files::MeshFile in = files::read_mesh(options->mesh);
    if (!options->quiet) print_notes(options->mesh, in.report);
    const measure::MeshFacts facts = measure::facts(in.mesh);
    write_json(options->json, {{"command", "info"},
                               {"file", options->mesh},
                               {"read", to_json(in.report)},
                               {"mesh", to_json(facts)}});
    if (!options->quiet && options->json != "-") print(options->mesh, in.report.format, facts);
    return 0;
  };
}

}  // namespace whittle::cli
