/// \file
/// `whittle`: simplify meshes, one or many, measure the error, and describe a file.
#include <fcntl.h>
#include <malloc.h>
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands.hh"
#include "cli/report.hh"
#include "version/Version.hh"

namespace {

constexpr int kBadUsage = 2;

/// A descriptor that was closed at the start would become that of the first file that is opened, and what is
/// printed would go there. What stands in for it fails when it is used.
void fill_standard_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(descriptor, F_GETFD) < 0) open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

/// Memory that is given back is kept for what comes next: a large array that is mapped anew each time takes the system
/// longer to clear than most passes over it.
void keep_memory() {
#ifdef __GLIBC__
  constexpr int most = 32 << 20;  // that the library takes
  mallopt(M_MMAP_THRESHOLD, most);
  mallopt(M_TRIM_THRESHOLD, most);
#endif
}

int refuse(const std::string& message) {
  whittle::cli::complain(message);
  return kBadUsage;
}

/// What to say of words that are no part of a command.
std::string unknown_words(const CLI::App& app) {
  const std::vector<std::string> words = app.remaining(true);
  const std::vector<CLI::App*> given = app.get_subcommands();
  const std::string command = given.empty() ? "whittle" : "whittle " + given.front()->get_name();
  for (const std::string& word : words)
    if (word.size() > 1 && word[0] == '-')
      return "there is no option " + word + "; " + command + " --help lists all";
  return words.empty()
             ? command + ": too many words"
             : "'" + words.front() + "' is one word too many; " + command + " --help says what it takes";
}

}  // namespace

int main(int argc, char** argv) {
  namespace cli = whittle::cli;
  fill_standard_descriptors();
  keep_memory();
  signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error of writing, after which no half of a file stays
  try {
    CLI::App app("Simplifies triangle meshes (OBJ, PLY, OFF, STL, OM, 3MF, glTF).", "whittle");
    app.require_subcommand(0, 1);
    app.set_version_flag("--version", whittle::version::text("whittle"));
    app.footer(
        "Exit codes: 0 done; 1 the target was not reached, the mesh is written as far as it came;\n"
        "2 bad usage or bad input, nothing is written.");
    const std::vector<std::pair<std::string, cli::Command>> commands{{"simplify", cli::add_simplify(app)},
                                                                     {"lods", cli::add_lods(app)},
                                                                     {"batch", cli::add_batch(app)},
                                                                     {"measure", cli::add_measure(app)},
                                                                     {"info", cli::add_info(app)},
                                                                     {"modules", cli::add_modules(app)},
                                                                     {"completion", cli::add_completion(app)},
                                                                     {"manual", cli::add_manual(app)}};
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      if (error.get_exit_code() == 0) {  // --help, --version
        std::ostringstream asked;
        app.exit(error, asked, asked);
        cli::print_text(asked.str());
        return 0;
      }
      if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) return refuse(unknown_words(app));
      return refuse(error.what());
    }
    for (const auto& [name, command] : commands)
      if (app.got_subcommand(name)) return command();
    return refuse("no command given; there are simplify, lods, batch, measure, info and modules");
  } catch (const std::bad_alloc&) {
    return refuse("not enough memory");
  } catch (const std::exception& error) {
    return refuse(error.what());
  }
}
