/// \file
/// `whittle`: simplify meshes, measure what was lost, and tell what is in a file.
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "whittle/commands.hh"

namespace {

constexpr int kBadUsage = 2;

/// One line, whatever the message holds.
int complain(std::string message) {
  for (char& c : message)
    if (c == '\n') c = ' ';
  std::cerr << "whittle: " << message << std::endl;
  return kBadUsage;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    CLI::App app("Simplifies triangle meshes (OBJ, PLY, OFF, STL).", "whittle");
    app.require_subcommand(0, 1);
    app.set_version_flag("--version", "whittle " WHITTLE_VERSION);
    app.footer(
        "Exit codes: 0 done; 1 the target was not reached, the mesh is written as far as it came;\n"
        "2 bad usage or bad input, nothing is written.");
    using whittle::cli::Command;
    const std::vector<std::pair<std::string, Command>> commands{{"simplify", whittle::cli::add_simplify(app)},
                                                                {"measure", whittle::cli::add_measure(app)},
                                                                {"info", whittle::cli::add_info(app)}};
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
      return complain(error.what());
    }
    for (const auto& [name, command] : commands)
      if (app.got_subcommand(name)) return command();
    return complain("no command given; there are simplify, measure and info");
  } catch (const std::bad_alloc&) {
    return complain("not enough memory");
  } catch (const std::exception& error) {
    return complain(error.what());
  }
}
