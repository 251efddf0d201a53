#include "files/Choice.hh"

#include <algorithm>
#include <cmath>

namespace whittle::files {
namespace {

using attributes::Attribute;
using attributes::Kind;

Place place_of(const Places& places, Kind kind) {
  switch (kind) {
    case Kind::normal:
      return places.normal;
    case Kind::colour:
      return places.colour;
    case Kind::texture:
      return places.texture;
    case Kind::scalar:
      return places.scalar;
    default:
      return Place::nowhere;
  }
}

void note_once(std::vector<std::string>& notes, const std::string& note) {
  if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
}

}  // namespace

Choice choose(const attributes::Attributes& attributes, const Places& places, WriteReport& report) {
  Choice choice;
  for (const Attribute& attribute : attributes) {
    const Place place = place_of(places, attribute.kind);
    if (place == Place::nowhere) {
      leave_out(report, to_string(attribute));
      continue;
    }
    if (place == Place::vertices && !attribute.per_vertex()) {
      leave_out(report, to_string(attribute) + " that differ between the corners of a vertex");
      continue;
    }
    const Attribute** only = attribute.kind == Kind::normal    ? &choice.normal
                             : attribute.kind == Kind::colour  ? &choice.colour
                             : attribute.kind == Kind::texture ? &choice.texture
                                                               : nullptr;
    if (only == nullptr)
      choice.scalars.push_back(&attribute);
    else if (*only == nullptr)
      *only = &attribute;
    else
      leave_out(report, "a second set of " + to_string(attribute));
  }
  return choice;
}

void leave_out(WriteReport& report, const std::string& what) {
  note_once(report.left_out, what);
}

void reduce(WriteReport& report, const std::string& line) {
  note_once(report.reduced, line);
}

std::uint8_t to_byte(float component) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(component, 0.0F, 1.0F) * 255.0F));
}

}  // namespace whittle::files
