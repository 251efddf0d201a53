#include "cli/commands.hh"
#include "cli/report.hh"
#include "recipe/Catalogue.hh"

namespace whittle::cli {

Command add_modules(CLI::App& app) {
  CLI::App* command = app.add_subcommand("modules", "List the modules with their keys, for --module");
  command->footer("Example:\n  whittle modules");
  return [] {
    print_text(recipe::catalogue_help());
    return 0;
  };
}

}  // namespace whittle::cli
