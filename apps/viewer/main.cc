/// \file
/// `whittle-viewer`: see what an algorithm does, while it does it.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <new>
#include <string>

#include "files/MeshFile.hh"
#include "model/RecipeText.hh"
#include "model/Script.hh"
#include "version/Version.hh"
#include "window/App.hh"

namespace {

using namespace whittle;
using namespace whittle::viewer;

constexpr int kBadUsage = 2;

/// One line, whatever the message holds.
int complain(std::string message) {
  for (char& c : message)
    if (c == '\n') c = ' ';
  std::cerr << "whittle-viewer: " << message << std::endl;
  return kBadUsage;
}

struct Options {
  std::string model, recipe, screenshot, script, settings, size;
  double budget = 30;
  bool by_itself() const { return !screenshot.empty() || !script.empty(); }
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("MODEL", options.model, "The mesh to open: OBJ, PLY, OFF, STL, OM, GLB or glTF");
  app.add_option("--recipe", options.recipe, "A recipe file, or its text, as 'fass:radius=0.8e'")
      ->type_name("FILE|TEXT");
  app.add_option("--screenshot", options.screenshot, "Write the window as PNG once all is done, and exit")
      ->type_name("OUT.png");
  app.add_option("--script", options.script, "Do what a file says, one command a line")->type_name("FILE");
  app.add_option("--size", options.size, "Of the window, in pixels of an ordinary screen")
      ->type_name("WIDTHxHEIGHT");
  app.add_option("--frame-budget", options.budget,
                 "For so long drawing a large mesh may hold up the window at a time; default 30")
      ->type_name("MILLISECONDS")
      ->check(CLI::Range(0.0, 10000.0));
  app.add_option("--settings", options.settings,
                 "Keep the settings in this file; without it, scripts and screenshots use none")
      ->type_name("FILE");
  app.set_version_flag("--version", whittle::version::text("whittle-viewer"));
  app.footer("Commands of a script:\n" + script_help() +
             "\nWithout a display: whittle-bench draws pictures, whittle simplifies.\n"
             "Exit codes: 0 done; 2 bad usage, bad input, or no display.");
}

std::string file_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw files::FileError(path + ": cannot be read");
  return text;
}

recipe::Recipe recipe_of(const std::string& file_or_text) {
  std::error_code ignored;
  if (std::filesystem::exists(file_or_text, ignored)) return load_recipe(file_or_text);
  return parse_options(file_or_text);
}

void set_size(const std::string& text, Settings& settings) {
  if (text.empty()) return;
  int width = 0, height = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 64 || height < 64 ||
      width > 16384 || height > 16384)
    throw files::FileError("--size " + text + " is not WIDTHxHEIGHT, each from 64 to 16384");
  settings.width = width;
  settings.height = height;
}

/// The last recipe of the user; one that is not understood any more is forgotten.
void restore_recipe(Session& session, const Settings& settings) {
  if (settings.recipe.empty()) return;
  try {
    session.change(parse_options(settings.recipe));
  } catch (const std::exception&) {
  }
}

int view(const Options& options) {
  std::filesystem::path settings_file = options.settings;
  if (settings_file.empty() && !options.by_itself()) settings_file = settings_path();
  Settings settings = settings_file.empty() ? Settings() : load_settings(settings_file);
  set_size(options.size, settings);
  std::vector<Command> script;
  if (!options.script.empty())
    script =
        parse_script(file_text(options.script), std::filesystem::path(options.script).filename().string());
  if (!options.screenshot.empty()) {
    if (options.model.empty() && script.empty()) throw files::FileError("--screenshot needs a MODEL");
    files::check_creatable(options.screenshot);
  }

  Session session([] { Window::wake(); });
  if (!options.recipe.empty())
    session.change(recipe_of(options.recipe));
  else
    restore_recipe(session, settings);
  if (!session.problem().empty() && options.by_itself()) throw recipe::RecipeError(session.problem());

  const bool visible = options.screenshot.empty() || !script.empty();
  Window window(settings.width, settings.height, "Whittle", visible);
  App app(window, session, settings, settings.view, options.budget);
  if (!options.model.empty()) session.open(options.model);
  if (options.by_itself() && !options.model.empty()) app.settle();
  if (!script.empty() || options.screenshot.empty()) app.run(std::move(script));
  if (!options.screenshot.empty()) {
    app.settle();
    files::write_file(options.screenshot,
                      render::encode_png(app.picture(window.width(), window.height(), true)));
  }
  if (!settings_file.empty()) {
    if (options.size.empty() && window.width() > 0) {  // as it will be asked for again, on whatever screen
      settings.width = static_cast<int>(std::lround(window.width() / window.content_scale()));
      settings.height = static_cast<int>(std::lround(window.height() / window.content_scale()));
    }
    settings.view = app.view();
    settings.recipe = options_text(session.recipe());
    save_settings(settings_file, settings);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    CLI::App app("Shows what a decimation does to a mesh, while it does it.", "whittle-viewer");
    Options options;
    add_options(app, options);
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
      return complain(error.what());
    }
    return view(options);
  } catch (const std::bad_alloc&) {
    return complain("not enough memory");
  } catch (const std::exception& error) {
    return complain(error.what());
  }
}
