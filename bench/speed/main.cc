/// \file
/// whittle-speed: how fast is a mesh decimated, and how well?
#include <iostream>

#include "files/MeshFile.hh"
#include "speed/CommandLine.hh"
#include "speed/json.hh"
#include "speed/markdown.hh"
#include "speed/models.hh"
#include "speed/shapes.hh"
#include "speed/textured/suite.hh"
#include "speed/threads.hh"

namespace {

namespace terminal = whittle::terminal;
namespace files = whittle::files;
namespace speed = whittle::speed;

constexpr int kBadUsageOrInput = 2;

std::filesystem::path file(const speed::CommandLine& line, const char* extension) {
  return line.out / (line.name + extension);
}

void report(const speed::CommandLine& line) {
  std::vector<speed::Json> runs;
  for (const auto& path : line.report) runs.push_back(speed::read_run(path));
  const std::string page = speed::markdown(runs);
  std::filesystem::create_directories(line.out);
  files::write_file(file(line, ".md"), page);
}

void run_shapes(const speed::CommandLine& line) {
  terminal::Progress progress(std::cerr, terminal::style_on_stderr(line.quiet));
  if (line.threads) speed::confine(*line.threads);
  std::filesystem::create_directories(line.out);
  files::check_creatable(file(line, ".md"));
  files::write_file(file(line, ".md"), speed::shapes_page(line.only, progress));
}

/// A run and its page. A file name need not be UTF-8; a replacement character is better than no results.
void write(const speed::CommandLine& line, const speed::Json& run) {
  files::write_file(file(line, ".json"),
                    run.dump(2, ' ', false, speed::Json::error_handler_t::replace) + "\n");
  files::write_file(file(line, ".md"), speed::markdown({run}));
}

void run_textured(const speed::CommandLine& line) {
  terminal::Progress progress(std::cerr, terminal::style_on_stderr(line.quiet));
  const auto models = speed::textured_models(WHITTLE_ASSET_CACHE, line.models, line.only);
  if (line.export_to) return speed::export_textured(models, *line.export_to);
  if (line.threads) speed::confine(*line.threads);
  std::filesystem::create_directories(line.out);
  files::check_creatable(file(line, ".json"));
  speed::TexturedSettings settings;
  settings.rounds = line.rounds.value_or(settings.rounds);
  settings.samples = line.samples.value_or(settings.samples);
  settings.peers = line.compare;
  settings.pictures = line.out / line.name;
  speed::Json run = speed::run_json(speed::allowed_threads(), line.only_text);
  run["suites"].push_back(speed::run_textured(models, settings, progress));
  write(line, run);
  progress.clear();
}

void run(const speed::CommandLine& line) {
  terminal::Progress progress(std::cerr, terminal::style_on_stderr(line.quiet));
  if (line.threads) speed::confine(*line.threads);
  speed::Json run = speed::run_json(speed::allowed_threads(), line.only_text);
  bool checked = false;
  for (const speed::Suite suite : line.suites) {
    const auto subjects = speed::load_models(line.models, WHITTLE_ASSET_CACHE, suite, line.subdivisions);
    if (!checked) {  // before the long part
      std::filesystem::create_directories(line.out);
      files::check_creatable(file(line, ".json"));
      checked = true;
    }
    const auto settings = line.settings(suite);
    run["suites"].push_back(speed::suite_json(settings, speed::run_rounds(settings, subjects, progress)));
  }
  write(line, run);
  progress.clear();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto line = speed::parse_command_line(argc, argv);
    if (!line.answer.empty()) {
      std::cout << line.answer;
      return 0;
    }
    if (line.shapes)
      run_shapes(line);
    else if (line.textured && line.report.empty())
      run_textured(line);
    else if (line.report.empty())
      run(line);
    else
      report(line);
    if (!line.quiet)
      std::cout << "results are in " << line.export_to.value_or(file(line, ".md")).string() << "\n";
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "whittle-speed: " << error.what() << "\n";
    return kBadUsageOrInput;
  }
}
