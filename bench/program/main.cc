/// \file
/// whittle-bench: how much faster is a decimated mesh drawn?
#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "files/MeshFile.hh"
#include "program/CommandLine.hh"
#include "program/Interrupt.hh"
#include "report/Report.hh"

namespace {

namespace bench = whittle::bench;
namespace egl = whittle::egl;
namespace files = whittle::files;
namespace render = whittle::render;

constexpr int kBadUsageOrInput = 2;
constexpr int kSignalBase = 128;  // what shells add to the number of a signal

void print_devices() {
  const auto devices = egl::list_devices();
  for (const auto& device : devices) {
    std::cout << device.number << "  " << (device.software ? "software" : "hardware") << "  ";
    try {
      const auto facts = egl::EglContext({device.number, false}).facts();
      std::cout << facts.renderer << "; OpenGL " << facts.version << "\n";
    } catch (const egl::EglError&) {
      std::cout << "does not give OpenGL 3.3\n";
    }
  }
  if (devices.empty()) std::cout << "EGL lists no devices; --device software may still work\n";
}

bench::ProgressStyle progress_style(bool quiet) {
  if (quiet) return bench::ProgressStyle::silent;
  return isatty(STDERR_FILENO) == 1 ? bench::ProgressStyle::terminal : bench::ProgressStyle::lines;
}

/// Pictures are larger than the timed image, but of its shape, so that they show what was timed.
struct PictureSize {
  int width, height;
};

PictureSize picture_size(const bench::Settings& settings) {
  constexpr int kLongerSide = 1024;
  const int longer = std::max(settings.width, settings.height);
  return {std::max(1, kLongerSide * settings.width / longer),
          std::max(1, kLongerSide * settings.height / longer)};
}

void stop_if_interrupted() {
  if (bench::interrupt_signal() != 0) throw bench::Stopped();
}

void run(const bench::CommandLine& line) {
  bench::Progress progress(std::cerr, progress_style(line.quiet));
  const egl::EglContext context(line.device);
  const auto environment = bench::environment(context.facts());
  const auto model = bench::load_model(line.model, WHITTLE_ASSET_CACHE, line.label);
  for (const auto& note : model.notes) std::cerr << "whittle-bench: " << note << "\n";
  std::filesystem::create_directories(line.out);
  if (!line.pictures_only) files::check_creatable(line.out / "results.json");

  const render::Renderer renderer;
  const auto& settings = line.settings;
  const auto views = bench::views(model.mesh, static_cast<double>(settings.width) / settings.height);
  const auto [width, height] = picture_size(settings);
  std::vector<bench::SetResult> sets;
  for (const auto& definition : line.sets) {
    stop_if_interrupted();
    progress.say("decimating and taking pictures: " + definition.paper_label);
    const auto& set = sets.emplace_back(bench::decimate(model.mesh, definition));
    const auto pictures = bench::take_pictures(renderer, views, set.mesh, width, height);
    const auto caption = bench::caption(model, definition);
    files::write_file(line.out / bench::picture_name(definition),
                      render::encode_png(pictures.whole, caption));
    files::write_file(line.out / bench::ears_picture_name(definition),
                      render::encode_png(pictures.ears, caption + ", detail"));
  }
  if (line.pictures_only) {
    progress.clear();
    if (!line.quiet) std::cout << "pictures are in " << line.out.string() << "\n";
    return;
  }
  bench::time_sets(renderer, views.whole, settings, sets, progress,
                   [] { return bench::interrupt_signal() != 0; });

  const bench::Report report{model, settings, environment, sets};
  files::write_file(line.out / "results.json", bench::json_text(report));
  files::write_file(line.out / "results.md", bench::markdown_text(report));
  progress.clear();
  if (!line.quiet) std::cout << "results are in " << (line.out / "results.md").string() << "\n";
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto line = bench::parse_command_line(argc, argv);
    if (!line.answer.empty()) {
      std::cout << line.answer;
      return 0;
    }
    if (line.list_devices) {
      print_devices();
      return 0;
    }
    bench::catch_interrupts();
    run(line);
    return 0;
  } catch (const bench::Stopped&) {
    std::cerr << "whittle-bench: interrupted; no results were written\n";
    return kSignalBase + bench::interrupt_signal();
  } catch (const std::exception& error) {
    std::cerr << "whittle-bench: " << error.what() << "\n";
    return kBadUsageOrInput;
  }
}
