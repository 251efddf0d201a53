#include <memory>

#include "attributes/transfer.hh"
#include "cli/commands.hh"
#include "cli/contents.hh"
#include "cli/report.hh"
#include "files/Outputs.hh"
#include "text/format.hh"
#include "text/printable.hh"
#include "whittle/surface/charts.hh"

namespace whittle::cli {
namespace {

/// What texture coordinates cut the surface into: pieces, and along seams.
std::size_t charts_of(const files::MeshFile& in, const attributes::Attribute& texture) {
  const auto wedges = attributes::seam_wedges({texture});
  return charts(in.mesh.triangles, wedges.empty() ? in.mesh.triangles : wedges).count;
}

/// Each attribute with its place: at vertices, or at corners where a vertex has several values.
Json attributes_json(const files::MeshFile& in) {
  Json out = Json::array();
  for (const attributes::Attribute& a : in.attributes) {
    Json one = {{"name", attributes::to_string(a)},
                {"at", a.per_vertex() ? "vertices" : "corners"},
                {"components", a.components},
                {"values", a.n_values()}};
    if (a.kind == attributes::Kind::texture) one["charts"] = charts_of(in, a);
    out.push_back(std::move(one));
  }
  return out;
}

std::string attributes_text(const Json& attributes) {
  std::string out;
  for (const Json& a : attributes) {
    out += text::format("  %-22s %s at %s", text::printable(a["name"].get<std::string>()).c_str(),
                        a["values"].dump().c_str(), a["at"].get<std::string>().c_str());
    if (const auto charts = a.find("charts"); charts != a.end())
      out += ", " + charts->dump() + (*charts == 1 ? " chart" : " charts");
    out += "\n";
  }
  return out;
}

std::string table(const std::string& path, const std::string& format, const measure::MeshFacts& f,
                  const Intersections& crossing) {
  std::string out = text::printable(path) + " (" + format + ")\n";
  const auto count = [&](const char* name, std::size_t n) { out += text::format("  %-22s %zu\n", name, n); };
  const auto size = [&](const char* name, double x) {
    out += text::format("  %-22s %s\n", name, figure(x).c_str());
  };
  count("vertices", f.vertices);
  count("faces", f.faces);
  count("edges", f.edges);
  count("components", f.components);
  out += text::format("  %-22s %ld\n", "Euler characteristic", f.euler_characteristic);
  count("boundary edges", f.boundary_edges);
  count("boundary loops", f.boundary_loops);
  count("non-manifold edges", f.nonmanifold_edges);
  count("non-manifold vertices", f.nonmanifold_vertices);
  count("isolated vertices", f.isolated_vertices);
  count("degenerate faces", f.degenerate_faces);
  count("duplicate faces", f.duplicate_faces);
  out += text::format("  %-22s %s\n", "intersecting pairs", count_of(crossing).c_str());
  size("area", f.area);
  size("volume", f.volume);
  size("mean edge", f.mean_edge);
  size("shortest edge", f.min_edge);
  size("longest edge", f.max_edge);
  size("box diagonal", f.diagonal);
  return out;
}

}  // namespace

Command add_info(CLI::App& app) {
  struct Options {
    std::string mesh, json;
    bool list = false, quiet = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("info", "Tell what is in a mesh file");
  command->add_option("MESH", options->mesh, "The mesh file")->required();
  command->add_option("--json", options->json, "Write the figures as JSON to a file, or to stdout for -");
  command->add_flag("--list-intersections", options->list,
                    "With --json: name the pairs of faces that intersect, as numbers from 0 in the order of "
                    "the faces read");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->footer("Example:\n  whittle info bunny.ply");
  return [options] {
    files::Outputs outputs;
    outputs.reads("MESH", options->mesh);
    outputs.add("--json", options->json);
    const files::MeshFile in = files::read_mesh(options->mesh);
    outputs.reads_beside("MESH", in.files_beside);
    const Json contents = contents_json(options->mesh, in);
    if (!options->quiet) {
      print_notes_on_shape(options->mesh, in.report);
      for (const std::string& line : in.report.lost_files()) complain(options->mesh + ": " + line);
    }
    const measure::MeshFacts facts = measure::facts(in.mesh);
    const Intersections crossing = intersections(in.mesh);
    const Json attributes = attributes_json(in);
    outputs.write("--json", json_text({{"command", "info"},
                                       {"file", options->mesh},
                                       {"read", to_json(in.report)},
                                       {"mesh", to_json(facts)},
                                       {"intersections", to_json(crossing, options->list)},
                                       {"attributes", attributes},
                                       {"contents", contents}}));
    if (!options->quiet && options->json != "-")
      print_text(table(options->mesh, in.report.format, facts, crossing) + attributes_text(attributes) +
                 contents_text(contents));
    outputs.commit();
    return 0;
  };
}

}  // namespace whittle::cli
