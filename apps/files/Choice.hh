/// \file
/// Which attributes a format takes.
#pragma once

#include <vector>

#include "files/MeshFile.hh"

namespace whittle::files {

/// Where a format can hold values of a kind.
enum class Place { nowhere, vertices, corners };

struct Places {
  Place normal = Place::nowhere;
  Place colour = Place::nowhere;
  Place texture = Place::nowhere;
  Place scalar = Place::nowhere;
};

/// What is written; null where there is none. The rest is in the report.
struct Choice {
  const attributes::Attribute* normal = nullptr;
  const attributes::Attribute* colour = nullptr;
  const attributes::Attribute* texture = nullptr;
  std::vector<const attributes::Attribute*> scalars;

  bool none() const { return !normal && !colour && !texture && scalars.empty(); }
};

/// One attribute of each kind, the first, and all scalars.
Choice choose(const attributes::Attributes& attributes, const Places& places, WriteReport& report);

/// Notes that something is not written, once.
void leave_out(WriteReport& report, const std::string& what);

/// Notes a line about something that is written with less in it, once.
void reduce(WriteReport& report, const std::string& line);

/// A colour's component as the 0..255 that it was or is nearest to.
std::uint8_t to_byte(float component);

/// The float that stands for a byte of a colour.
inline float from_byte(std::uint8_t byte) {
  return static_cast<float>(byte) / 255.0F;
}

/// A texture coordinate's v, counted the way asked for.
inline float v_of(const attributes::Attribute& texture, std::size_t value, bool downwards) {
  const float v = texture.value(value)[1];
  return texture.downwards == downwards ? v : 1.0F - v;
}

}  // namespace whittle::files
