/// \file
/// What the commands print, and where they write JSON.
#pragma once

#include <string>
#include <vector>

#include "figures/json.hh"

namespace whittle::cli {

using figures::Json;
using figures::to_json;

/// JSON as a file has it. A file's name need not be UTF-8: what is not becomes a replacement character.
std::string json_text(const Json& json);

/// The paths of files that are written beside a result.
Json names_of(const std::vector<files::Companion>& companions);

/// The same as a line of text, "written beside: a.bin, skin.png"; empty where there are none.
std::string beside_line(const Json& paths);

/// Prints to standard output. \throw files::FileError  it is full or closed
void print_text(const std::string& text);

/// The same for a summary of what has been written to files already: if it cannot be printed, that is said on
/// stderr.
/// \return whether it was printed
bool print_summary(const std::string& text);

/// Reports on stderr what a reader had to change or leave out.
/// \param quiet  only the files that are named and were not read
void print_notes(const std::string& path, const files::ReadReport& report, bool quiet = false);

/// Only what matters to the shape.
void print_notes_on_shape(const std::string& path, const files::ReadReport& report);

/// A line on stderr in the program's name, whatever the message holds.
void complain(const std::string& message);

/// Why a target was missed, what is the matter with the input included; empty where it was reached.
std::vector<std::string> missed_because(const recipe::Recipe& recipe, const files::MeshFile& in,
                                        const recipe::Result& result);

/// The same as one line, and what would help.
std::string why_missed(const recipe::Recipe& recipe, const files::MeshFile& in, const recipe::Result& result);

/// How many pairs of faces intersect, as text: "12", or "1000000 or more".
std::string count_of(const Intersections& intersections);

/// A figure with six digits; in words where it is beyond what a number can be.
std::string figure(double value);

}  // namespace whittle::cli
