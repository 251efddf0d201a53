#include "speed/CommandLine.hh"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "version/Version.hh"

namespace whittle::speed {
namespace {

/// CLI11 sets some of its messages over several lines.
std::string one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::vector<Suite> suites(const std::string& name) {
  if (name == "figures") return {Suite::figures};
  if (name == "growth") return {Suite::growth};
  if (name == "truth") return {Suite::truth};
  return {Suite::figures, Suite::growth};
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  CommandLine line;
  std::vector<std::string> models, report;
  std::string suite = "figures", compare, export_to, out = line.out.string();

  CLI::App app("Times Whittle's executors against OpenMesh's decimaters and other libraries.",
               "whittle-speed");
  app.set_version_flag("--version", version::text("whittle-speed"));
  app.add_option("models", models, "Mesh files (default: the bunny and the dragon in assets/cache)");
  app.add_option(
         "--suite", suite,
         "figures: all contenders; growth: how times grow with the model; all: both; truth: error "
         "and topology of mq; shapes: how times grow where very many faces meet; textured: mq on models with "
         "texture coordinates or colours")
      ->capture_default_str()
      ->check(CLI::IsMember({"figures", "growth", "all", "truth", "shapes", "textured"}));
  app.add_option("--rounds", line.rounds, "How often each contender is timed (default: 7; growth: 3)")
      ->check(CLI::Range(1, 1000));
  app.add_option("--samples", line.samples,
                 "Samples a side for the distances of the results (default: 200000; textured: 100000)")
      ->check(CLI::Range(1, 100000000));
  app.add_option("--subdivisions", line.subdivisions,
                 "growth: the last model is cut 1 to 4 up to so many times")
      ->capture_default_str()
      ->check(CLI::Range(0, 4));
  app.add_option("--only", line.only_text,
                 "Regular expression: only contenders in whose name it is found; textured: only models");
  app.add_option("--compare", compare,
                 "textured: a folder with PEER/MODEL-PERCENT.glb, which are measured, too");
  app.add_option("--export", export_to, "textured: no run; write the models as GLB into this folder");
  app.add_option("--threads", line.threads, "Processors that the process may use (default: all)")
      ->check(CLI::Range(1, 4096));
  app.add_option("--out", out, "Folder for NAME.json and NAME.md; made if missing")->capture_default_str();
  app.add_option("--name", line.name, "Name of the two files")->capture_default_str();
  app.add_option("--report", report, "No run: one page NAME.md from these results of earlier runs");
  app.add_flag("--quiet", line.quiet, "No progress; errors still come");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    std::ostringstream text;
    app.exit(asked, text, text);
    line.answer = text.str();
    return line;
  } catch (const CLI::ParseError& error) {
    throw UsageError(one_line(error.what()));
  }
  line.shapes = suite == "shapes";
  line.textured = suite == "textured";
  if (!line.textured && !(compare.empty() && export_to.empty()))
    throw UsageError("--compare and --export are of --suite textured");
  if (!compare.empty()) line.compare = compare;
  if (!export_to.empty()) line.export_to = export_to;
  if (line.compare && !std::filesystem::is_directory(*line.compare))
    throw UsageError("--compare: \"" + compare + "\" is no folder");
  if (line.shapes && !(report.empty() && models.empty()))
    throw UsageError("--suite shapes makes its meshes itself: it takes no models and no --report");
  if (!report.empty() && !models.empty()) throw UsageError("--report takes results, no models");
  if (line.name.empty() || line.name.find('/') != std::string::npos)
    throw UsageError("--name: \"" + line.name + "\" is no name of a file");
  if (line.only_text) try {
      line.only = std::regex(*line.only_text);
    } catch (const std::regex_error&) {
      throw UsageError("--only: \"" + *line.only_text + "\" is no regular expression");
    }
  line.suites = suites(suite);
  line.models.assign(models.begin(), models.end());
  line.report.assign(report.begin(), report.end());
  line.out = out;
  return line;
}

}  // namespace whittle::speed
