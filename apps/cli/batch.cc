#include "batch/Batch.hh"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <thread>
#include <utility>

#include "cli/RecipeOptions.hh"
#include "cli/changes.hh"
#include "cli/commands.hh"
#include "cli/report.hh"
#include "files/Outputs.hh"
#include "terminal/Progress.hh"
#include "text/format.hh"
#include "text/number.hh"
#include "text/printable.hh"

namespace whittle::cli {
namespace {

using batch::Outcome;

struct Options : RecipeOptions {
  std::string source, out, format, json;
  std::size_t jobs = 0;
  std::optional<double> time_limit;
  std::optional<std::size_t> memory_limit;
  bool resume = false, ascii = false, quiet = false, verbose = false;
};

volatile sig_atomic_t interrupted = 0;

/// The first signal ends the batch in order; a second one is not caught any more.
void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupted = 1; };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction old {};
    sigaction(signal, nullptr, &old);
    if (old.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);  // nohup ignores a hang-up
  }
}

/// The arguments of `whittle simplify`, without the files.
std::vector<std::string> simplify_arguments(const Options& options) {
  std::vector<std::string> out;
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) out.push_back(name + ("=" + value));  // a value may begin with a minus
  };
  const auto add_number = [&](const char* name, const auto& value) {
    if (value) add(name, Json(*value).dump());
  };
  for (const std::string& module : options.modules) add("--module", module);
  for (const std::string& lock : options.locks) add("--lock", lock);
  for (const std::string& what : options.drop) add("--drop", what);
  for (const std::string& what : options.seams) add("--seams", what);
  add_number("--ratio", options.ratio);
  add_number("--faces", options.faces);
  add_number("--vertices", options.vertices);
  add_number("--delaunay", options.delaunay);
  add("--max-distance", options.max_distance);
  add("--samples", std::to_string(options.samples));
  add("--weights", options.weights);
  add("--driver", options.driver);
  add("--repair", options.repair);
  if (options.weld > 0) add("--weld", text::shortest(options.weld));
  add("--pieces", options.pieces);
  if (options.force) out.emplace_back("--force");
  if (options.refit) out.emplace_back(*options.refit ? "--refit" : "--no-refit");
  if (options.each_mesh) out.emplace_back("--each-mesh");
  if (options.flatten) out.emplace_back("--flatten");
  if (options.copy_materials) out.emplace_back("--copy-materials");
  if (options.quantize > 0) out.push_back("--quantize=" + std::to_string(options.quantize));
  add("--compress", options.compress);
  if (options.ascii) out.emplace_back("--ascii");
  return out;
}

std::string own_path() {
  std::array<char, 4096> path{};
  const ssize_t length = readlink("/proc/self/exe", path.data(), path.size());
  if (length <= 0 || static_cast<std::size_t>(length) == path.size())
    throw batch::BatchError("cannot tell where this program is");
  return {path.data(), static_cast<std::size_t>(length)};
}

bool is_bad(const Outcome& outcome) {
  using Status = Outcome::Status;
  return outcome.status == Status::failed || outcome.status == Status::missed ||
         outcome.status == Status::missed_before;
}

/// What there is to say of a mesh besides its row.
std::string details(const Outcome& outcome) {
  std::string out;
  if (outcome.notes.is_array())
    for (const Json& note : outcome.notes)
      if (note.is_string()) out += "  " + text::printable(note.get<std::string>()) + "\n";
  return out + vanished_lines(outcome.charts, outcome.pieces) + changes_line(outcome.attribute_changes);
}

std::string table(const std::vector<batch::Item>& items, const std::vector<Outcome>& outcomes, bool all) {
  std::string out = text::format("%-40s %12s %12s %9s  %s\n", "file", "faces", "left", "seconds", "");
  std::string below;
  std::map<std::string, std::size_t> counts;
  std::size_t untold = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Outcome& outcome = outcomes[i];
    const std::string name = text::printable(items[i].in.string());
    ++counts[batch::to_string(outcome.status)];
    if (!all && !is_bad(outcome)) {
      if (outcome.notes.is_array() && !outcome.notes.empty()) ++untold;
      continue;
    }
    out += text::format("%-40s %12zu %12zu %9.2f  %s%s%s\n", name.c_str(), outcome.faces_before,
                        outcome.faces_after, outcome.seconds, batch::to_string(outcome.status).c_str(),
                        outcome.message.empty() ? "" : ": ", text::printable(outcome.message).c_str());
    if (const std::string more = details(outcome); !more.empty()) below += name + ":\n" + more;
  }
  if (!below.empty()) out += "\n" + below + "\n";
  if (untold > 0)
    out += text::format("notes on %zu meshes more: --verbose prints them, --json has them\n", untold);
  out += text::format("%zu meshes:", items.size());
  for (const auto& [status, count] : counts) out += text::format(" %zu %s;", count, status.c_str());
  return out + "\n";
}

Json describe(const Options& options, const std::vector<batch::Item>& items,
              const std::vector<Outcome>& outcomes, const std::vector<std::string>& problems) {
  std::map<std::string, std::size_t> counts;
  Json meshes = Json::array();
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Outcome& outcome = outcomes[i];
    const std::string status = batch::to_string(outcome.status);
    ++counts[status];
    meshes.push_back({{"in", items[i].in.string()},
                      {"out", items[i].out.string()},
                      {"status", status},
                      {"message", outcome.message.empty() ? Json(nullptr) : Json(outcome.message)},
                      {"faces_before", outcome.faces_before},
                      {"faces_after", outcome.faces_after},
                      {"seconds", outcome.seconds},
                      {"notes", outcome.notes},
                      {"attribute_changes", outcome.attribute_changes}});
  }
  return {{"command", "batch"}, {"source", options.source},
          {"out", options.out}, {"interrupted", interrupted != 0},
          {"statuses", counts}, {"problems", problems},
          {"meshes", meshes}};
}

/// Reports of other runs are replaced. Anything else may be what one of many meshes names, an image or a library, and
/// looking for it would take as long as reading all.
void check_is_report(const std::string& path) {
  std::error_code error;
  if (path.empty() || !std::filesystem::is_regular_file(path, error)) return;
  std::ifstream file(path);
  char first = '{';
  file >> first;
  if (first != '{') throw batch::BatchError("--json would overwrite " + path + ", which is no report");
}

int run_batch(const Options& options) {
  make_recipe(options);  // what is wrong with it is wrong before anything is begun
  files::WriteOptions format;
  format.format = options.format;
  if (!options.format.empty()) set_packing(options, {"--format " + options.format}, format);
  batch::Order order;
  if (options.out == "-")
    throw batch::BatchError("--out: results cannot go to standard output; ./- is a folder of that name");
  batch::Listing listing = batch::list_items(options.source, options.out, options.format);
  order.items = std::move(listing.items);
  files::Outputs outputs;
  for (const batch::Item& item : order.items) outputs.reads(item.in.string(), item.in);
  outputs.add("--json", options.json);
  check_is_report(options.json);
  order.out = options.out;
  order.program = own_path();
  order.arguments = simplify_arguments(options);
  order.named_files = selection_files(options);
  order.jobs = options.jobs > 0 ? options.jobs : std::max(1u, std::thread::hardware_concurrency());
  order.limits = {options.time_limit, options.memory_limit};
  order.resume = options.resume;
  if (order.items.empty())
    throw batch::BatchError(listing.problems.empty() ? options.source + ": there are no meshes"
                                                     : listing.problems.front());
  for (const std::string& problem : listing.problems) complain(problem);

  catch_interrupts();
  terminal::Progress progress(std::cerr, terminal::style_on_stderr(options.quiet));
  progress.expect(order.items.size());
  progress.show(0, order.items.size(), "");
  const auto outcomes = batch::run(
      order,
      [&](std::size_t done, const batch::Item& item, const Outcome& outcome) {
        if (is_bad(outcome)) {
          progress.clear();
          complain(item.in.string() + ": " + batch::to_string(outcome.status) +
                   (outcome.message.empty() ? "" : ": " + outcome.message));
        }
        progress.show(done, order.items.size(), item.in.filename().string());
      },
      [] { return interrupted != 0; });
  progress.clear();

  constexpr std::size_t kShort = 40;  // lines: longer reports list failures only
  outputs.write("--json", json_text(describe(options, order.items, outcomes, listing.problems)));
  outputs.commit();
  const bool printed =
      options.quiet || options.json == "-" ||
      print_summary(table(order.items, outcomes, options.verbose || outcomes.size() <= kShort));
  if (interrupted != 0) complain("interrupted; --resume goes on from here");
  const auto unlogged =
      std::count_if(outcomes.begin(), outcomes.end(), [](const auto& o) { return !o.logged; });
  if (unlogged > 0) complain(std::to_string(unlogged) + " lines are missing in the log: no room for them");
  const bool all_well = std::none_of(outcomes.begin(), outcomes.end(), is_bad) && listing.problems.empty();
  return all_well && printed && unlogged == 0 && interrupted == 0 ? 0 : 1;
}

}  // namespace

Command add_batch(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("batch", "Simplify many meshes");
  command
      ->add_option(
          "SOURCE", options->source,
          "A folder, whose meshes are taken with those of the folders in it; or a text file with the "
          "name of a mesh on each line")
      ->required();
  command->add_option("--out", options->out, "Folder for the results; made if missing")
      ->required()
      ->type_name("DIR");
  command->add_option("--jobs", options->jobs, "How many meshes at the same time; default: all processors")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1024}))
      ->type_name("N");
  command
      ->add_option("--format", options->format,
                   "Write obj, ply, off, stl, om, glb, gltf or 3mf; default: what each was")
      ->check(CLI::IsMember({"obj", "ply", "off", "stl", "om", "glb", "gltf", "3mf"}));
  command->add_option("--time-limit", options->time_limit, "Give up on a mesh after so long")
      ->check(CLI::Range(0.001, 1e9))
      ->type_name("SECONDS");
  command
      ->add_option("--memory-limit", options->memory_limit, "Let no mesh take more address space than this")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 40))
      ->type_name("MIB");
  command->add_flag("--resume", options->resume,
                    "Leave out what is done already, with the same options and from the same file");
  add_recipe_options(*command, *options, true);
  command->add_option("--json", options->json,
                      "Write what became of each mesh as JSON to a file, or to stdout for -");
  command->add_flag("--ascii", options->ascii, "Write PLY and STL as text");
  auto* quiet = command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->add_flag("--verbose", options->verbose, "List every mesh at the end, however many")
      ->excludes(quiet);
  command->footer(
      "Exit codes: 0 all done; 1 a mesh failed or missed its target, or a folder could not be listed; 2 bad "
      "usage.\n"
      "Start it as often as you like on the same folders, also on several machines, with --resume: each mesh "
      "is\n"
      "done once. A line for each goes to DIR/.whittle/log/*.jsonl.\n\n"
      "Examples:\n"
      "  whittle batch scans --out small --ratio 0.1 --jobs 4 --time-limit 600\n"
      "  whittle batch list.txt --out small --max-distance 0.1% --format glb --resume");
  return [options] { return run_batch(*options); };
}

}  // namespace whittle::cli
