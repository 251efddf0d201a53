#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hh"
#include "cli/report.hh"
#include "recipe/Catalogue.hh"
#include "recipe/Recipe.hh"

namespace whittle::cli {
namespace {

std::string joined(const std::vector<std::string>& words, const char* between = " ") {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : between) + word;
  return out;
}

std::vector<const CLI::App*> commands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

std::vector<std::string> names(const CLI::App& app) {
  std::vector<std::string> out;
  for (const CLI::App* command : commands(app)) out.push_back(command->get_name());
  return out;
}

std::vector<std::string> options(const CLI::App& command) {
  std::vector<std::string> out;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) out.push_back("--" + name);
  return out;
}

std::vector<std::string> modules() {
  std::vector<std::string> out;
  for (const auto& module : recipe::catalogue()) out.push_back(module.name);
  return out;
}

std::vector<std::string> drivers() {
  std::vector<std::string> out;
  for (const auto& driver : recipe::drivers()) out.emplace_back(driver.name);
  return out;
}

/// The values that an option can have, where that is known.
struct Choice {
  const char* option;
  std::vector<std::string> values;
};

std::vector<Choice> choices() {
  return {{"--module", modules()},
          {"--driver", drivers()},
          {"--repair", {"none", "report", "fix"}},
          {"--drop", {"normals", "colours", "texture", "materials"}},
          {"--seams", {"normals", "colours", "groups"}},
          {"--pieces", {"keep", "by-error"}},
          {"--lock", {"boundary", "feature:", "selection:"}},
          {"--format", {"obj", "ply", "off", "stl", "om", "glb", "gltf", "3mf"}}};
}

/// \param function  that the shell calls
std::string bash(const CLI::App& app, const std::string& function) {
  std::string out = function +
                    "() {\n"
                    "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
                    "  COMPREPLY=()\n"
                    "  if ((COMP_CWORD == 1)); then\n"
                    "    COMPREPLY=($(compgen -W '" +
                    joined(names(app)) +
                    " --help --version' -- \"$word\"))\n"
                    "    return\n"
                    "  fi\n"
                    "  case $before in\n";
  for (const Choice& choice : choices())
    out += "    " + std::string(choice.option) + ") COMPREPLY=($(compgen -W '" + joined(choice.values) +
           "' -- \"$word\")); return ;;\n";
  out +=
      "  esac\n"
      "  if [[ $word == -* ]]; then\n"
      "    case ${COMP_WORDS[1]} in\n";
  for (const CLI::App* command : commands(app))
    out += "      " + command->get_name() + ") COMPREPLY=($(compgen -W '" + joined(options(*command)) +
           "' -- \"$word\")) ;;\n";
  return out +
         "    esac\n"
         "    return\n"
         "  fi\n"
         "  local name\n"  // a name may hold blanks and stars
         "  while IFS= read -r name; do COMPREPLY+=(\"$name\"); done < <(compgen -f -- \"$word\")\n"
         "}\n"
         "complete -o filenames -F " +
         function + " whittle\n";
}

std::string fish(const CLI::App& app) {
  std::string out = "complete -c whittle -n __fish_use_subcommand -f\n";
  for (const CLI::App* command : commands(app)) {
    out += "complete -c whittle -n __fish_use_subcommand -f -a " + command->get_name() + "\n";
    for (const CLI::Option* option : command->get_options())
      for (const std::string& name : option->get_lnames())
        out += "complete -c whittle -n '__fish_seen_subcommand_from " + command->get_name() + "' -l " + name +
               (option->get_type_size() != 0 ? " -r" : "") + "\n";
  }
  for (const Choice& choice : choices())
    out += "complete -c whittle -l " + std::string(choice.option).substr(2) + " -x -a '" +
           joined(choice.values) + "'\n";
  return out;
}

/// bash's, by zsh's help for such. As an autoloaded function it is first called to complete something.
std::string zsh(const CLI::App& app) {
  return "#compdef whittle\nautoload -U +X bashcompinit && bashcompinit\n" + bash(app, "_whittle_words") +
         "if [[ ${funcstack[1]} == _whittle ]]; then _bash_complete -o filenames -F _whittle_words; fi\n";
}

int print_completion(const CLI::App& app, const std::string& shell) {
  print_text(shell == "fish" ? fish(app) : shell == "zsh" ? zsh(app) : bash(app, "_whittle"));
  return 0;
}

}  // namespace

Command add_completion(CLI::App& app) {
  const auto shell = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("completion", "Print what a shell needs to complete commands and options");
  command->add_option("SHELL", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->footer("Example:\n  source <(whittle completion bash)");
  return [shell, &app] { return print_completion(app, *shell); };
}

}  // namespace whittle::cli
