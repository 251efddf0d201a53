#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "attributes/TextureError.hh"
#include "cli/changes.hh"
#include "cli/commands.hh"
#include "cli/report.hh"
#include "files/Outputs.hh"
#include "measure/certify.hh"
#include "recipe/Recipe.hh"
#include "text/format.hh"
#include "whittle/surface/errors.hh"

namespace whittle::cli {
namespace {

const attributes::Attribute* texture_of(const files::MeshFile& file) {
  const auto found = std::find_if(file.attributes.begin(), file.attributes.end(),
                                  [](const auto& a) { return a.kind == attributes::Kind::texture; });
  return found == file.attributes.end() ? nullptr : &*found;
}

/// How far the first texture coordinates have slid; nothing where a file has none, or those of the original no area.
std::optional<attributes::TextureError> slid(const files::MeshFile& original,
                                             const files::MeshFile& simplified,
                                             const attributes::TextureErrorOptions& options) {
  const auto *before = texture_of(original), *after = texture_of(simplified);
  if (!before || !after) return std::nullopt;
  try {
    return attributes::texture_error(original.mesh, *before, simplified.mesh, *after, options);
  } catch (const InvalidMesh&) {
    complain(
        "the texture coordinates of the original enclose no area; how far they have slid is not measured");
    return std::nullopt;
  }
}

std::string line(const attributes::TextureError& e, const std::string& texels) {
  return text::format("%-22s %14s %14s   %s; %zu of %zu charts left\n", "texture, RMS and max",
                      figure(e.rms).c_str(), figure(e.max).c_str(), texels.c_str(), e.charts_left, e.charts);
}

std::string line(const measure::CertifiedDistance& d, double diagonal) {
  const auto row = [&](const char* name, double x) {
    return text::format("%-22s %14s %14s\n", name, figure(x).c_str(), figure(100 * x / diagonal).c_str());
  };
  return row("max, proved: at least", d.lower) + row("and at most", d.upper);
}

std::string table(const measure::MeshFacts& a, const measure::MeshFacts& b, const Intersections& of_a,
                  const Intersections& of_b, const measure::Distance& d,
                  const std::optional<measure::CertifiedDistance>& certified) {
  std::string out = text::format("%-22s %14s %14s\n", "", "original", "simplified");
  const auto count = [&](const char* name, std::size_t x, std::size_t y) {
    out += text::format("%-22s %14zu %14zu\n", name, x, y);
  };
  const auto size = [&](const char* name, double x, double y) {
    out += text::format("%-22s %14s %14s\n", name, figure(x).c_str(), figure(y).c_str());
  };
  count("vertices", a.vertices, b.vertices);
  count("faces", a.faces, b.faces);
  count("components", a.components, b.components);
  out += text::format("%-22s %14ld %14ld\n", "Euler characteristic", a.euler_characteristic,
                      b.euler_characteristic);
  count("boundary edges", a.boundary_edges, b.boundary_edges);
  count("non-manifold edges", a.nonmanifold_edges, b.nonmanifold_edges);
  count("degenerate faces", a.degenerate_faces, b.degenerate_faces);
  out +=
      text::format("%-22s %14s %14s\n", "intersecting pairs", count_of(of_a).c_str(), count_of(of_b).c_str());
  size("area", a.area, b.area);
  size("volume", a.volume, b.volume);

  out += text::format("\n%-22s %14s %14s\n", "distance, two-sided", "model units", "% of diagonal");
  const auto distance = [&](const char* name, double x) {
    out += text::format("%-22s %14s %14s\n", name, figure(x).c_str(), figure(100 * x / d.diagonal).c_str());
  };
  distance("RMS", d.two_sided.rms);
  distance("mean", d.two_sided.mean);
  distance("max", d.two_sided.max);
  if (certified) out += line(*certified, d.diagonal);
  out += text::format("%-22s %14zu   turned by more than 90 degrees against the nearest original face\n",
                      "flipped faces", d.flipped_faces);
  return out;
}

/// \throw FileError  there is no surface to measure from
void require_area(const std::string& path, const IndexedMesh& mesh, const measure::MeshFacts& facts) {
  if (facts.faces > 0 && facts.area > 0 && std::isfinite(facts.area)) return;
  constexpr double largest = 1e150, least = 1e-150;  // whose squares are numbers
  std::string why = ": no face has an area";
  if (facts.faces == 0) why = ": there are no faces";
  double size = 0;  // along an axis, so that nothing is squared
  for (const IndexedMesh::Point& point : mesh.points)
    size = std::max(size, (point - mesh.points[0]).cwiseAbs().maxCoeff());
  if (size > largest) why = ": too large; the areas of its faces are beyond what a number can be";
  if (size > 0 && size < least) why = ": too small; the areas of its faces round to 0";
  throw files::FileError((path == "-" ? "standard input" : path) + why);
}

}  // namespace

Command add_measure(CLI::App& app) {
  struct Options {
    std::string original, simplified, json;
    std::size_t samples = measure::DistanceOptions().samples;
    std::optional<std::string> certify;
    std::optional<double> texels;
    bool list = false, quiet = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("measure", "Tell how far a simplified mesh lies from its original");
  command->add_option("ORIGINAL", options->original, "The mesh before")->required();
  command->add_option("SIMPLIFIED", options->simplified, "The mesh after")->required();
  command->add_option("--samples", options->samples, "Sample points on each surface, besides the vertices")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000000000}))
      ->capture_default_str();
  command
      ->add_option("--certify", options->certify,
                   "Prove also bounds on the largest distance over all points of both surfaces. LENGTH is no "
                   "limit on that "
                   "distance, but how far the two bounds may lie apart: much less than the distance, as a "
                   "tenth of the max "
                   "measured; smaller takes longer. In model units, in mean edges of the original (0.1e) or "
                   "in percent of its "
                   "diagonal (0.01%)")
      ->type_name("LENGTH");
  command
      ->add_option(
          "--texels", options->texels,
          "Size of the texture that its figures are in. Default: that of the original's image, as simplify "
          "has it, else 1024")
      ->check(CLI::Range(1.0, 1e6));
  command->add_option("--json", options->json, "Write the figures as JSON to a file, or to stdout for -");
  command->add_flag("--list-intersections", options->list,
                    "With --json: name the pairs of faces that intersect, as numbers from 0 in the order of "
                    "the faces read");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->footer(
      "Examples:\n  whittle measure bunny.ply small.ply\n  whittle measure bunny.ply small.ply --certify "
      "0.01%");
  return [options] {
    files::Outputs outputs;
    outputs.reads("ORIGINAL", options->original);
    outputs.reads("SIMPLIFIED", options->simplified);
    outputs.add("--json", options->json);
    std::optional<recipe::Length> within;
    if (options->certify) within = recipe::parse_length(*options->certify);
    const files::MeshFile original = files::read_mesh(options->original);
    const files::MeshFile simplified = files::read_mesh(options->simplified);
    outputs.reads_beside("ORIGINAL", original.files_beside);
    outputs.reads_beside("SIMPLIFIED", simplified.files_beside);
    if (!options->quiet) {
      print_notes_on_shape(options->original, original.report);
      print_notes_on_shape(options->simplified, simplified.report);
    }
    const measure::MeshFacts before = measure::facts(original.mesh), after = measure::facts(simplified.mesh);
    require_area(options->original, original.mesh, before);
    require_area(options->simplified, simplified.mesh, after);
    measure::DistanceOptions sampling;
    sampling.samples = options->samples;
    const measure::Distance distance = measure::distance(original.mesh, simplified.mesh, sampling);
    std::optional<measure::CertifiedDistance> certified;
    if (within)
      certified =
          measure::certify(original.mesh, simplified.mesh, within->in(recipe::measure_scale(original.mesh)));
    attributes::TextureErrorOptions on_texture;
    on_texture.samples = options->samples;
    const Intersections of_before = intersections(original.mesh), of_after = intersections(simplified.mesh);
    const Json image = options->texels
                           ? Json(nullptr)
                           : count_in_texels_of(files::texture_image_size(original.parts), on_texture);
    on_texture.texels = options->texels.value_or(on_texture.texels);
    const auto texture = slid(original, simplified, on_texture);
    Json of_texture = texture ? to_json(*texture, on_texture.texels) : Json(nullptr);
    if (texture) of_texture["image"] = image;
    outputs.write(
        "--json",
        json_text({{"command", "measure"},
                   {"original",
                    {{"file", options->original},
                     {"mesh", to_json(before)},
                     {"intersections", to_json(of_before, options->list)}}},
                   {"simplified",
                    {{"file", options->simplified},
                     {"mesh", to_json(after)},
                     {"intersections", to_json(of_after, options->list)}}},
                   {"distance", to_json(distance)},
                   {"certified", certified ? to_json(*certified, distance.diagonal) : Json(nullptr)},
                   {"texture", of_texture}}));
    const std::string texels = options->texels ? "texels of " + figure(*options->texels) : texels_text(image);
    if (!options->quiet && options->json != "-")
      print_text(table(before, after, of_before, of_after, distance, certified) +
                 (texture ? line(*texture, texels) : ""));
    outputs.commit();
    return 0;
  };
}

}  // namespace whittle::cli
