#include "program/CommandLine.hh"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

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
void parse_size(const std::string& text, Settings& settings) {
  const auto cross = text.find('x');
  const auto width = parse_number<int>(text.substr(0, cross));
  const auto height = cross == std::string::npos ? width : parse_number<int>(text.substr(cross + 1));
  constexpr int kSmallest = 16, kLargest = 16384;
  if (!width || !height || std::min(*width, *height) < kSmallest || std::max(*width, *height) > kLargest)
    throw UsageError("--size: \"" + text + "\" is not a size such as 512 or 640x480, " +
                     std::to_string(kSmallest) + " to " + std::to_string(kLargest) + " pixels");
  settings.width = *width;
  settings.height = *height;
}

egl::DeviceChoice parse_device(const std::string& text) {
  if (text.empty()) return {};
  if (text == "software") return {std::nullopt, true};
  if (const auto number = parse_number<std::size_t>(text)) return {number, false};
  throw UsageError("--device: \"" + text + "\" is neither a device number nor \"software\"");
}

/// CLI11 sets some of its messages over several lines.
std::string one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  CommandLine line;
  std::string size = "512", device;
  std::vector<std::string> sets;
  std::optional<std::string> model;
  std::string out = line.out.string();
  std::size_t from = line.settings.frames.from, to = line.settings.frames.to;

  CLI::App app(
      "Decimates a model with the paper's algorithms and times how fast each result is drawn off-screen.",
      "whittle-bench");
  app.option_defaults()->take_last();  // so that a script's defaults can be overridden behind them
  app.set_version_flag("--version", std::string("whittle-bench ") + WHITTLE_VERSION);
  app.add_option("--model", model, "Mesh file (default: the bunny in assets/cache, else a generated mesh)");
  app.add_option("--label", line.label, "What to call the model in the results");
  app.add_option("--size", size, "Timed image in pixels: 512 or 640x480")->capture_default_str();
  app.add_option("--repetitions", line.settings.repetitions, "How often each set is timed")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_option("--frames-from", from, "First timed frame; the ones before warm up")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000000));
  app.add_option("--frames-to", to, "End of the timed frames")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  app.add_option("--device", device, "EGL device number, or \"software\" (default: hardware if any works)");
  app.add_option("--out", out, "Folder for results.json, results.md and pictures")->capture_default_str();
  app.add_option("--sets", sets,
                 "Names of sets, apart by commas, or \"all\"; the original is always one (default: all)")
      ->delimiter(',')
      ->take_all();
  app.add_flag("--pictures-only", line.pictures_only, "Take the pictures, time nothing, write no results");
  app.add_flag("--list-devices", line.list_devices, "List the EGL devices with their renderers, and exit");
  app.add_flag("--quiet", line.quiet, "No progress; errors and notes on the model still come");
  try {
    app.parse(argc, argv);
    line.sets = choose_sets(sets);
  } catch (const CLI::Success& asked) {
    std::ostringstream text;
    app.exit(asked, text, text);
    line.answer = text.str();
    return line;
  } catch (const CLI::ParseError& error) {
    throw UsageError(one_line(error.what()));
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--sets: ") + error.what());
  }
  if (from >= to) throw UsageError("--frames-from must be below --frames-to");
  line.settings.frames = {from, to};
  parse_size(size, line.settings);
  line.device = parse_device(device);
  if (model) line.model = *model;
  line.out = out;
  return line;
}

}  // namespace whittle::bench
