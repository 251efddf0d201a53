#include "model/RecipeText.hh"

#include <fstream>
#include <iterator>

#include "files/MeshFile.hh"
#include "model/number.hh"
#include "model/words.hh"

namespace whittle::viewer {
namespace {

using recipe::Recipe;
using recipe::RecipeError;

/// Options with a value that control the command's output, not its work.
bool is_about_output(const std::string& option) {
  return option == "--json";
}

std::size_t to_count(const std::string& option, const std::string& value) {
  const auto number = to_number(value);
  if (!number || *number < 1 || *number != static_cast<double>(static_cast<std::size_t>(*number)))
    throw RecipeError(option + " " + value + " is not a whole number of at least 1");
  return static_cast<std::size_t>(*number);
}

double to_real(const std::string& option, const std::string& value) {
  const auto number = to_number(value);
  if (!number) throw RecipeError(option + " " + value + " is not a number");
  return *number;
}

void set_option(Recipe& recipe, const std::string& option, const std::string& value) {
  if (option == "--module")
    recipe.modules.push_back(recipe::parse_spec(value));
  else if (option == "--ratio")
    recipe.target.ratio = to_real(option, value);
  else if (option == "--faces")
    recipe.target.faces = to_count(option, value);
  else if (option == "--vertices")
    recipe.target.vertices = to_count(option, value);
  else if (option == "--delaunay")
    recipe.delaunay = to_real(option, value);
  else if (option == "--max-distance")
    recipe.max_distance = recipe::parse_length(value);
  else if (option == "--driver")
    recipe.driver = recipe::parse_driver(value);
  else if (!is_about_output(option))
    throw RecipeError("unknown option '" + option +
                      "'; there are --module, --ratio, --faces, --vertices, --max-distance, --delaunay, "
                      "--refit, --no-refit and --driver");
}

}  // namespace

std::string options_text(const Recipe& recipe) {
  std::string text;
  const auto add = [&](const std::string& option, const std::string& value) {
    text += (text.empty() ? "" : " ") + option + " " + quote(value);
  };
  for (const recipe::Spec& spec : recipe.modules) add("--module", spec.text());
  if (recipe.target.ratio) add("--ratio", text::shortest(*recipe.target.ratio));
  if (recipe.target.faces) add("--faces", std::to_string(*recipe.target.faces));
  if (recipe.target.vertices) add("--vertices", std::to_string(*recipe.target.vertices));
  if (recipe.max_distance) add("--max-distance", recipe.max_distance->text());
  if (recipe.delaunay) add("--delaunay", text::shortest(*recipe.delaunay));
  if (recipe.driver != recipe::Driver::automatic) add("--driver", recipe::to_string(recipe.driver));
  if (recipe.refit) text += *recipe.refit ? " --refit" : " --no-refit";
  return text;
}

std::string command_text(const Recipe& recipe, const std::string& in, const std::string& out) {
  return "whittle simplify " + quote(in) + " " + quote(out) + " " + options_text(recipe);
}

std::string levels_command_text(const Recipe& recipe, const std::string& in, const std::string& out) {
  return "whittle lods " + quote(in) + " --out " + quote(out) + " --levels 2 --ratio " +
         text::shortest(*recipe.target.ratio);
}

Recipe parse_options(const std::string& text) {
  std::vector<std::string> words;
  try {
    words = split_words(text);
  } catch (const WordsError& error) {
    throw RecipeError(error.what());
  }
  Recipe recipe;
  std::size_t files_to_skip = 0, i = 0;
  if (words.size() >= 2 && words[0] == "whittle" && words[1] == "simplify") {
    i = 2;
    files_to_skip = 2;
  }
  for (; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word.rfind("--", 0) != 0) {
      if (files_to_skip > 0)
        --files_to_skip;
      else
        recipe.modules.push_back(recipe::parse_spec(word));
      continue;
    }
    if (word == "--quiet" || word == "--ascii") continue;
    if (word == "--refit" || word == "--no-refit") {
      recipe.refit = word == "--refit";
      continue;
    }
    const std::size_t equals = word.find('=');
    if (equals != std::string::npos) {
      set_option(recipe, word.substr(0, equals), word.substr(equals + 1));
      continue;
    }
    if (i + 1 == words.size()) throw RecipeError("option " + word + " needs a value");
    set_option(recipe, word, words[++i]);
  }
  return recipe;
}

Recipe load_recipe(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw files::FileError(path + ": cannot be read");
  try {
    return parse_options(text);
  } catch (const RecipeError& error) {
    throw RecipeError(path + ": " + error.what());
  }
}

void save_recipe(const std::string& path, const Recipe& recipe) {
  files::write_file(path, options_text(recipe) + "\n");
}

}  // namespace whittle::viewer
