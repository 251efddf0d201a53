#include "cli/report.hh"

#include <unistd.h>

#include <cstdlib>
#include <iostream>

#include "text/number.hh"

namespace whittle::cli {

void check_json_target(const std::string& target) {
  if (!target.empty() && target != "-") files::check_creatable(target);
}

void write_json(const std::string& target, const Json& json) {
  const std::string text = json.dump(2) + "\n";
  if (target == "-")
    std::cout << text << std::flush;
  else if (!target.empty())
    files::write_file(target, text);
}

void complain(std::string message) {
  for (char& c : message)
    if (c == '\n') c = ' ';
  const bool colour = isatty(STDERR_FILENO) == 1 && std::getenv("NO_COLOR") == nullptr;
  std::cerr << (colour ? "\033[1mwhittle:\033[0m " : "whittle: ") << message << std::endl;
}

void print_notes(const std::string& path, const files::ReadReport& report) {
  for (const std::string& note : report.notes()) complain(path + ": " + note);
}

std::string figure(double value) {
  return text::significant(value, 6);
}

}  // namespace whittle::cli
