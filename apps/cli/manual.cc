#include <algorithm>

#include "cli/commands.hh"
#include "cli/report.hh"
#include "recipe/Catalogue.hh"
#include "version/Version.hh"

namespace whittle::cli {
namespace {

/// What roff would take for its own is escaped.
std::string roff(const std::string& text) {
  std::string out;
  bool at_line_start = true;
  for (const char c : text) {
    if (at_line_start && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
    at_line_start = c == '\n';
  }
  return out;
}

std::string option_text(const CLI::Option& option) {
  std::string head = option.get_positional() ? option.get_name(true) : option.get_name(false, true);
  if (option.get_type_size() != 0 && !option.get_positional()) {
    const std::string type = option.get_type_name();
    head += " " + (type.empty() ? "VALUE" : type.substr(0, type.find(':')));
  }
  std::string out = ".TP\n.B " + roff(head) + "\n" + roff(option.get_description());
  if (!option.get_default_str().empty()) out += roff(" (default: " + option.get_default_str() + ")");
  return out + "\n";
}

std::string command_text(CLI::App& command) {
  std::string out =
      ".SS " + roff("whittle " + command.get_name()) + "\n" + roff(command.get_description()) + ".\n";
  for (const CLI::Option* option : command.get_options())
    if (option->get_name() != "--help") out += option_text(*option);
  if (const std::string footer = command.get_footer(); !footer.empty())
    out += ".PP\n.nf\n" + roff(footer) + "\n.fi\n";
  return out;
}

int print_manual(CLI::App& app) {
  std::string out = ".TH WHITTLE 1 \"\" \"whittle " + version::number() + "\" \"User commands\"\n";
  out += ".SH NAME\nwhittle \\- simplify triangle meshes\n";
  out += ".SH SYNOPSIS\n";
  const auto commands =
      app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
  for (const CLI::App* command : commands) {
    std::string line = ".B whittle " + roff(command->get_name()) + "\n";
    for (const CLI::Option* option : command->get_options())
      if (option->get_positional()) line += roff(option->get_name(true)) + "\n";
    out += line + "[options]\n.br\n";
  }
  out += ".SH DESCRIPTION\n" + roff(app.get_description()) + "\n";
  out += ".SH COMMANDS\n";
  for (CLI::App* command : commands) out += command_text(*command);
  out += ".SH MODULES\n.nf\n" + roff(recipe::catalogue_help()) + ".fi\n";
  out += ".SH EXIT STATUS\n.nf\n" + roff(app.get_footer()) + "\n.fi\n";
  print_text(out);
  return 0;
}

}  // namespace

Command add_manual(CLI::App& app) {
  app.add_subcommand("manual", "Print the man page")->group("");
  return [&app] { return print_manual(app); };
}

}  // namespace whittle::cli
