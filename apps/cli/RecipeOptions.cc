#include "cli/RecipeOptions.hh"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "recipe/Catalogue.hh"
#include "recipe/locks.hh"
#include "text/number.hh"

namespace whittle::cli {
namespace {

/// Other spellings of what can be left out.
CLI::Validator plain_words() {
  return CLI::Validator(
      [](std::string& text) {
        constexpr std::pair<const char*, const char*> words[] = {
            {"normal", "normals"},   {"color", "colours"},      {"colors", "colours"}, {"colour", "colours"},
            {"textures", "texture"}, {"material", "materials"}, {"group", "groups"}};
        for (const auto& [other, word] : words)
          if (text == other) text = word;
        return std::string();
      },
      "");
}

void add_target(CLI::App& command, RecipeOptions& options) {
  auto* ratio =
      command
          .add_option("--ratio", options.ratio,
                      "Keep this part of the faces, above 0, as 0.1 or 10%; 1 changes nothing but the "
                      "format")
          ->transform(share())
          ->type_name("R");
  auto* faces = command.add_option("--faces", options.faces, "Down to at most so many faces");
  auto* vertices = command.add_option("--vertices", options.vertices, "Down to at most so many vertices");
  const CLI::Validator count(
      [](std::string& text) {
        return text.empty() || text[0] == '-' || text == "0" ? "must be at least 1" : std::string();
      },
      "");
  faces->check(count)->type_name("N");
  vertices->check(count)->type_name("N");
  ratio->excludes(faces)->excludes(vertices);
  faces->excludes(vertices);
}

/// "auto, bulk, … or mc"
std::string driver_names() {
  std::string text;
  const auto& all = recipe::drivers();
  for (std::size_t i = 0; i < all.size(); ++i)
    text += (i == 0 ? "" : i + 1 < all.size() ? ", " : " or ") + std::string(all[i].name);
  return text;
}

/// The importance of each vertex as a factor of thresholds: what counts twice may move half as far.
std::vector<float> tolerances(const std::string& name, const files::MeshFile& in) {
  constexpr float kFree = 1e6f;
  std::vector<float> out;
  std::string known;
  for (const auto& attribute : in.attributes) {
    if (attribute.kind != attributes::Kind::scalar) continue;
    known += (known.empty() ? "" : ", ") + attribute.name;
    if (attribute.name != name) continue;
    // Where vertices of the file have become one, the most important of them counts.
    std::vector<float> weights(in.mesh.points.size(), 0);
    const auto take = [&](std::size_t v, std::uint32_t value) {
      const float weight = *attribute.value(value);
      if (!(weight >= 0))
        throw recipe::RecipeError("--weights " + name + ": vertex " + std::to_string(v) +
                                  " has a weight that is negative or not a number");
      weights[v] = std::max(weights[v], weight);
    };
    for (std::uint32_t v = 0; attribute.per_vertex() && v < weights.size(); ++v) take(v, v);
    for (std::size_t f = 0; !attribute.per_vertex() && f < in.mesh.triangles.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k) take(in.mesh.triangles[f][k], attribute.corners[f][k]);
    for (const float weight : weights) out.push_back(std::min(kFree, 1 / weight));
    return out;
  }
  throw recipe::RecipeError("--weights: the mesh has no vertex property '" + name + "'; " +
                            (known.empty() ? "it has none" : "there are " + known));
}

bool has_word(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// What options and modules call a kind of attributes.
std::string word_of(attributes::Kind kind) {
  switch (kind) {
    case attributes::Kind::normal:
      return "normals";
    case attributes::Kind::colour:
      return "colours";
    case attributes::Kind::texture:
      return "texture";
    default:
      return "";
  }
}

}  // namespace

CLI::Validator share() {
  return CLI::Validator(
      [](std::string& text) {
        double value = 0;
        const bool is_percent = !text.empty() && text.back() == '%';
        const std::string number = is_percent ? text.substr(0, text.size() - 1) : text;
        if (!CLI::detail::lexical_cast(number, value) || !std::isfinite(value))
          return "must be a part of the faces, as 0.1 or 10%, not '" + text + "'";
        if (!is_percent && value > 1 && value <= 100)
          return "the ratio must be above 0 and at most 1; " + text + " % of the faces is " +
                 text::shortest(value / 100) + " or " + text + "%";
        if (is_percent) text = text::shortest(value / 100);
        return std::string();
      },
      "");
}

void add_recipe_options(CLI::App& command, RecipeOptions& options, bool with_target) {
  command
      .add_option("--module", options.modules,
                  "NAME[:KEY=VALUE,...]; several run one after the other. Default with a target: mq")
      ->type_name("SPEC")
      ->take_all()
      ->expected(1);
  if (with_target) add_target(command, options);
  if (with_target)
    command.add_flag(
        "--each-mesh", options.each_mesh,
        "From glTF to glTF: the target holds for each mesh, instead of for all meshes of the scene together");
  command
      .add_option(
          "--pieces", options.pieces,
          "Which pieces, parts that share no vertex, may vanish as a whole: keep, none; by-error, those that "
          "cost less than what else would have to go; LENGTH, those with a smaller bounding box, without a "
          "target "
          "or a module only these")
      ->type_name("RULE")
      ->capture_default_str();
  command.add_flag(
      "--force", options.force,
      "Go on to the target where small pieces or locked vertices hold so much that the rest is ruined");
  command
      .add_option(
          "--max-distance", options.max_distance,
          "No point of either surface may lie farther than this from the other; kept for every module")
      ->type_name("LENGTH");
  command
      .add_option("--samples", options.samples, "Sample points on each surface where a distance is measured")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000000000}))
      ->capture_default_str();
  command
      .add_option("--lock", options.locks,
                  "Keep vertices in place: boundary; feature:DEGREES, at edges sharper than that; "
                  "selection:FILE, a text file of vertex numbers from 0. May be given several times")
      ->type_name("WHAT")
      ->take_all()
      ->expected(1);
  command
      .add_option("--weights", options.weights,
                  "A vertex property of the file: 1 is neutral, 2 keeps twice as true, 0 does not matter")
      ->type_name("PROPERTY");
  command
      .add_option(
          "--drop", options.drop,
          "Leave normals, colours, texture or materials out: it is not written and does not count. May be "
          "given several times")
      ->type_name("WHAT")
      ->transform(plain_words())
      ->check(CLI::IsMember({"normals", "colours", "texture", "materials"}))
      ->take_all()
      ->expected(1);
  command
      .add_option(
          "--seams", options.seams,
          "Where normals or colours differ at the corners of a vertex, or where groups of faces meet, it "
          "moves "
          "along their border only, as along those of texture and materials. May be given several times")
      ->type_name("WHAT")
      ->transform(plain_words())
      ->check(CLI::IsMember({"normals", "colours", "groups"}))
      ->take_all()
      ->expected(1);
  command.add_flag(
      "--flatten", options.flatten,
      "glTF: write one mesh, each as often as the scene shows it, without nodes, animations and what else "
      "is kept otherwise");
  command.add_flag(
      "--copy-materials", options.copy_materials,
      "Copy libraries of materials and images that are files beside the result, instead of referring to "
      "them where they are");
  command
      .add_flag("--quantize{16}", options.quantize,
                "glTF: round coordinates to 16 bits, or to --quantize=BITS from 8 to 16, of the largest "
                "extent of each "
                "mesh; normals to 8, texture coordinates to 16 (KHR_mesh_quantization)")
      ->check(CLI::Range(8, 16));
  command
      .add_option("--compress", options.compress,
                  "glTF: pack vertices and triangles, in an order that caches like, by meshopt "
                  "(EXT_meshopt_compression)")
      ->type_name("HOW")
      ->check(CLI::IsMember({"meshopt"}));
  command.add_flag_function(
      "--refit,!--no-refit", [&options](std::int64_t given) { options.refit = given > 0; },
      "At the end move the vertices to where the faces lie closest to the input, or do not. "
      "Default: with mq, unless the distance is bounded");
  command
      .add_option("--delaunay", options.delaunay,
                  "Retriangulate at the end, by flips of edges no sharper than DEGREES; 20 keeps the shape")
      ->type_name("DEGREES");
  command.add_option("--driver", options.driver, driver_names())->capture_default_str();
  command
      .add_option("--repair", options.repair, "What to do about damage: none, report (say it), fix (mend it)")
      ->check(CLI::IsMember({"none", "report", "fix"}))
      ->capture_default_str();
  command
      .add_option("--weld", options.weld,
                  "Join vertices no farther than this from each other, model units; at most 1 % of the "
                  "diagonal. Equal ones are joined in any case")
      ->check(CLI::Validator(
          [](std::string& text) {
            double length = 0;
            const bool good = CLI::detail::lexical_cast(text, length) && length > 0 && std::isfinite(length);
            return good ? std::string() : "must be a positive length in model units, not '" + text + "'";
          },
          ""))
      ->type_name("UNITS");
}

void set_packing(const RecipeOptions& options, const std::vector<std::string>& outs,
                 files::WriteOptions& format) {
  format.quantize = options.quantize;
  format.meshopt = options.compress == "meshopt";
  if (format.quantize == 0 && !format.meshopt) return;
  for (const std::string& out : outs)
    if (!files::holds_scenes(out, format))
      throw recipe::RecipeError(std::string(format.meshopt ? "--compress" : "--quantize") +
                                " is for glTF: " + out + " is another format");
}

recipe::Recipe make_recipe(const RecipeOptions& options) {
  recipe::Recipe recipe;
  for (const std::string& text : options.modules) recipe.modules.push_back(recipe::parse_spec(text));
  recipe.target = {options.ratio, options.faces, options.vertices};
  if (!options.max_distance.empty()) try {
      recipe.max_distance = recipe::parse_length(options.max_distance);
    } catch (const recipe::RecipeError& error) {
      throw recipe::RecipeError(std::string("--max-distance: ") + error.what());
    }
  try {
    recipe.pieces = recipe::parse_pieces(options.pieces);
  } catch (const recipe::RecipeError& error) {
    throw recipe::RecipeError(std::string("--pieces: ") + error.what());
  }
  recipe.force = options.force;
  const bool only_pieces =
      recipe.pieces.what == recipe::PieceRule::What::below && !recipe.target.any() && !recipe.max_distance;
  if (recipe.modules.empty() && !only_pieces) {
    if (!recipe.target.any() && !recipe.max_distance)
      throw recipe::RecipeError(
          "--module is required where neither --ratio, --faces, --vertices nor --max-distance is given");
    recipe.modules.push_back(recipe::default_module());
  }
  recipe.samples = options.samples;
  recipe.driver = recipe::parse_driver(options.driver);
  recipe.delaunay = options.delaunay;
  recipe.refit = options.refit;
  recipe::check(recipe);
  for (const std::string& text : options.locks) recipe::parse_lock(text);
  return recipe;
}

std::vector<std::string> selection_files(const RecipeOptions& options) {
  std::vector<std::string> files;
  for (const std::string& text : options.locks)
    if (const recipe::Lock lock = recipe::parse_lock(text); lock.what == recipe::Lock::What::selection)
      files.push_back(lock.file);
  return files;
}

void read_selections(const RecipeOptions& options, files::Outputs& outputs) {
  for (const std::string& file : selection_files(options)) outputs.reads("--lock", file);
}

files::ReadOptions read_options(const RecipeOptions& options) {
  files::ReadOptions read;
  read.repair = options.repair == "none"  ? files::Repair::none
                : options.repair == "fix" ? files::Repair::fix
                                          : files::Repair::report;
  read.weld = options.weld;
  return read;
}

void require_faces(const std::string& path, const files::MeshFile& in) {
  if (in.mesh.triangles.empty())
    throw files::FileError((path == "-" ? "standard input" : path) +
                           ": there are no faces, so no target can be reached");
}

std::vector<std::string> drop_attributes(const RecipeOptions& options, const std::string& out,
                                         const files::WriteOptions& format, files::MeshFile& in) {
  attributes::Attributes& all = in.attributes;
  all.erase(
      std::remove_if(all.begin(), all.end(),
                     [&](const auto& attribute) { return has_word(options.drop, word_of(attribute.kind)); }),
      all.end());
  if (has_word(options.drop, "materials")) in.parts.drop_materials();
  std::vector<std::string> left_out;
  if (in.scene) return left_out;  // glTF holds all that was read of it
  if (in.parts.has_materials() && !files::holds_materials(out, format, in.parts)) {
    in.parts.drop_materials();
    left_out.push_back("materials");
  }
  const std::vector<std::string> unwritable =
      files::take_unwritable(all, out, format, [&](const attributes::Attribute& attribute) {
        const std::string key = word_of(attribute.kind);
        return !key.empty() &&
               std::any_of(options.modules.begin(), options.modules.end(), [&](const auto& text) {
                 const recipe::Spec module = recipe::parse_spec(text);
                 return recipe::find_module(module.name).find(key) != nullptr &&
                        module.length(key, {1, 1}).value_or(0) > 0;
               });
      });
  left_out.insert(left_out.end(), unwritable.begin(), unwritable.end());
  return left_out;
}

void give_parts(const RecipeOptions& options, const files::MeshFile& in, recipe::Givens& givens) {
  givens.areas = in.parts.areas(has_word(options.seams, "groups"));
  givens.parts = &in.parts.of_face;
  givens.diagonal = in.diagonal;
}

recipe::Givens make_givens(const RecipeOptions& options, const files::MeshFile& in) {
  recipe::Givens givens;
  for (const std::string& text : options.locks)
    recipe::parse_lock(text).apply(in.mesh, in.vertex_of, givens.flags);
  if (!options.weights.empty()) givens.tolerance = tolerances(options.weights, in);
  givens.attributes = &in.attributes;
  givens.seams = {has_word(options.seams, "normals"), has_word(options.seams, "colours")};
  return givens;
}

std::string recipe_help() {
  return "A LENGTH is in model units (0.0012), in mean edges (0.8e) or in percent of the bounding box's "
         "diagonal (0.5%).\n"
         "With a target and no threshold, the threshold is searched for.\n"
         "whittle modules lists the modules and their keys.\n";
}

}  // namespace whittle::cli
