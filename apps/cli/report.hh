/// \file
/// What the commands print, and where they write JSON.
#pragma once

#include <string>

#include "figures/json.hh"

namespace whittle::cli {

using figures::Json;
using figures::to_json;

/// Where `--json` goes: a file, `-` for standard output, or empty for nowhere.
void check_json_target(const std::string& target);
void write_json(const std::string& target, const Json& json);

/// Reports on stderr what a reader had to change or leave out.
void print_notes(const std::string& path, const files::ReadReport& report);

/// A line on stderr in the program's name, whatever the message holds.
void complain(std::string message);

/// A figure with six digits.
std::string figure(double value);

}  // namespace whittle::cli
