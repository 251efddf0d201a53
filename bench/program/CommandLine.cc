#include "program/CommandLine.hh"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "experiment/Sets.hh"
#include "experiment/Views.hh"
#include "version/Version.hh"

namespace whittle::bench {
namespace {

/// A whole number and nothing else.
template <typename Number>
std::optional<Number> parse_number(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// "512" or "640x480".
ImageSize parse_size(const std::string& text) {
  const auto cross = text.find('x');
  const auto width = parse_number<int>(text.substr(0, cross));
  const auto height = cross == std::string::npos ? width : parse_number<int>(text.substr(cross + 1));
  constexpr int kSmallest = 16, kLargest = 16384;
  if (!width || !height || std::min(*width, *height) < kSmallest || std::max(*width, *height) > kLargest)
    throw UsageError("--size: \"" + text + "\" is not a size such as 512 or 640x480, " +
                     std::to_string(kSmallest) + " to " + std::to_string(kLargest) + " pixels");
  return {*width, *height};
}

egl::DeviceChoice parse_device(const std::string& text) {
  if (text.empty()) return {};
  if (text == "software") return {std::nullopt, true};
  if (const auto number = parse_number<std::size_t>(text)) return {number, false};
  throw UsageError("--device: \"" + text + "\" is neither a device number nor \"software\"");
}

std::vector<std::string> choose_experiments(const std::vector<std::string>& names) {
  std::vector<std::string> chosen;
  std::string known;
  for (const char* experiment : kExperiments) {
    if (names.empty() || std::count(names.begin(), names.end(), experiment) > 0) chosen.push_back(experiment);
    known += (known.empty() ? "" : ", ") + std::string(experiment);
  }
  for (const auto& name : names)
    if (std::count(chosen.begin(), chosen.end(), name) == 0)
      throw UsageError("--experiments: there is no \"" + name + "\"; there are " + known);
  return chosen;
}

/// CLI11 sets some of its messages over several lines.
std::string one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// What CLI11 fills in before it is checked.
struct Raw {
  std::string size, device, out, results;
  std::vector<std::string> sets, experiments;
  std::optional<std::string> model, monkey;
};

void add_options(CLI::App& app, CommandLine& line, Raw& raw) {
  app.option_defaults()->take_last();  // so that a script's defaults can be overridden behind them
  app.set_version_flag("--version", version::text("whittle-bench"));
  app.add_flag("--quick", line.quick, "Few frames, about four minutes on software GL (default there)");
  app.add_flag("--paper", line.paper, "The papers' frames and ten repetitions (default on a graphics card)");
  app.add_option("--experiments", raw.experiments, "paper1, paper2, beyond, apart by commas (default: all)")
      ->delimiter(',')
      ->take_all();
  app.add_option("--sets", raw.sets,
                 "Sets of Paper 1, apart by commas, or \"all\"; the original is always one (default: all)")
      ->delimiter(',')
      ->take_all();
  app.add_option("--model", raw.model,
                 "Mesh file (default: the bunny in assets/cache, else a generated mesh)");
  app.add_option("--monkey", raw.monkey,
                 "Mesh file for Paper 2 (default: Suzanne in assets/cache, else left out)");
  app.add_option("--label", line.label, "What to call the model in the results");
  app.add_option("--size", raw.size, "Timed image in pixels: 512 or 640x480 (default: 256)");
  app.add_option("--repetitions", line.repetitions, "How often each set is timed")
      ->check(CLI::Range(1, 1000));
  app.add_option("--frames-from", line.frames_from, "First timed frame; the ones before warm up")
      ->check(CLI::Range(0, 1000000));
  app.add_option("--frames-to", line.frames_to, "End of the timed frames")->check(CLI::Range(1, 1000000));
  app.add_option("--views", line.views, "How many views PSNR and SSIM compare (default: 6)")
      ->check(CLI::Range(1, static_cast<int>(kMostViews)));
  app.add_option("--samples", line.samples, "Sample points a side for distances")
      ->check(CLI::Range(1, 100000000));
  app.add_option("--device", raw.device,
                 "EGL device number, or \"software\" (default: hardware if any works)");
  app.add_option("--out", raw.out, "Folder for results, report and pictures (default: results)");
  app.add_flag("--resume", line.resume, "Go on with the unfinished results in the folder");
  app.add_flag("--pictures-only", line.pictures_only, "Take the pictures, time nothing, write no results");
  app.add_flag("--list-devices", line.list_devices, "List the EGL devices with their renderers, and exit");
  app.add_flag("--quiet", line.quiet, "No progress; errors and notes on the model still come");
  app.footer(
      "Exit codes: 0 done; 1 not all of it could be done, what was found out is kept; 2 bad usage or input.");
}

}  // namespace

Protocol CommandLine::protocol(bool software) const {
  Protocol chosen = paper || (!quick && !software) ? paper_protocol() : quick_protocol();
  if (size) {
    chosen.settings.width = size->width;
    chosen.settings.height = size->height;
  }
  chosen.settings.views = views.value_or(chosen.settings.views);
  chosen.settings.samples = samples.value_or(chosen.settings.samples);
  for (const char* experiment : kExperiments) {
    Timing& timing = chosen.timing(experiment);
    timing.repetitions = repetitions.value_or(timing.repetitions);
    timing.frames_from = frames_from.value_or(timing.frames_from);
    timing.frames_to = frames_to.value_or(timing.frames_to);
    if (timing.frames_from >= timing.frames_to)
      throw UsageError("--frames-from must be below --frames-to, also of the protocol (" +
                       std::string(experiment) + ": " + std::to_string(timing.frames_from) + " to " +
                       std::to_string(timing.frames_to) + ")");
  }
  if (size || views || samples || repetitions || frames_from || frames_to)
    chosen.name += ", changed by options";
  return chosen;
}

CommandLine parse_command_line(int argc, const char* const* argv) {
  CommandLine line;
  Raw raw;
  CLI::App app(
      "Decimates models with the papers' algorithms and times how fast each result is drawn off-screen.",
      "whittle-bench");
  add_options(app, line, raw);
  app.require_subcommand(0, 1);
  CLI::App* const report =
      app.add_subcommand("report", "Make the report of a results.json again; draws nothing");
  report->add_option("RESULTS", raw.results, "results.json of a run, finished or not")->required();
  report->add_option("--out", raw.out, "Folder for the report (default: where the results are)");
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
  if (report->parsed()) {
    line.report = raw.results;
    line.out =
        raw.out.empty() ? std::filesystem::path(raw.results).parent_path() : std::filesystem::path(raw.out);
    if (line.out.empty()) line.out = ".";
    return line;
  }
  if (line.quick && line.paper) throw UsageError("--quick and --paper exclude one another");
  try {
    line.sets = choose_sets(raw.sets);
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--sets: ") + error.what());
  }
  line.experiments = choose_experiments(raw.experiments);
  line.device = parse_device(raw.device);
  if (!raw.size.empty()) line.size = parse_size(raw.size);
  if (raw.model) line.model = *raw.model;
  if (raw.monkey) line.monkey = *raw.monkey;
  if (!raw.out.empty()) line.out = raw.out;
  line.protocol(true);  // throws what is wrong with the frames
  return line;
}

}  // namespace whittle::bench
