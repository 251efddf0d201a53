/// \file
/// What the commands print and write as JSON. Every figure's name ends with its unit; plain names are counts.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "files/MeshFile.hh"
#include "measure/Distance.hh"
#include "measure/MeshFacts.hh"
#include "recipe/Recipe.hh"

namespace whittle::cli {

using Json = nlohmann::ordered_json;

Json to_json(const measure::MeshFacts& facts);
Json to_json(const measure::Distance& distance);
Json to_json(const recipe::StageResult& stage);
Json to_json(const files::ReadReport& report);

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
