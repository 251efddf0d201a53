#include "files/PlyColumns.hh"

#include <algorithm>
#include <cmath>

#include "files/Choice.hh"
#include "files/Fault.hh"

namespace whittle::files {
namespace {

using attributes::Attribute;
using attributes::Kind;

constexpr std::size_t not_found = static_cast<std::size_t>(-1);

bool has_kind(const attributes::Attributes& attributes, Kind kind) {
  return std::any_of(attributes.begin(), attributes.end(),
                     [&](const Attribute& a) { return a.kind == kind; });
}

/// True if a 32-bit float holds every value of the type.
bool fits_float(PlyType type) {
  return type != PlyType::float64 && type != PlyType::int32 && type != PlyType::uint32;
}

/// Properties that are one attribute together. Of each kind the first group that is complete counts.
struct Group {
  Kind kind;
  const char* names[4];
  std::size_t required;
  std::size_t most;
};

constexpr Group groups[] = {
    {Kind::normal, {"nx", "ny", "nz"}, 3, 3},
    {Kind::colour, {"red", "green", "blue", "alpha"}, 3, 4},
    {Kind::colour, {"r", "g", "b", "a"}, 3, 4},
    {Kind::colour, {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"}, 3, 4},
    {Kind::texture, {"s", "t"}, 2, 2},
    {Kind::texture, {"u", "v"}, 2, 2},
    {Kind::texture, {"texture_u", "texture_v"}, 2, 2},
};

std::size_t find(const PlyElement& element, std::string_view name) {
  for (std::size_t i = 0; i < element.properties.size(); ++i)
    if (element.properties[i].name == name && !element.properties[i].is_list) return i;
  return not_found;
}

/// Empty where the group is not complete.
std::vector<std::size_t> properties_of(const PlyElement& element, const Group& group) {
  std::vector<std::size_t> properties;
  while (properties.size() < group.most) {
    const std::size_t property = find(element, group.names[properties.size()]);
    if (property == not_found) break;
    properties.push_back(property);
  }
  if (properties.size() < group.required) properties.clear();
  return properties;
}

}  // namespace

std::vector<std::size_t> ply_colour_properties(const PlyElement& element) {
  for (const Group& group : groups) {
    if (group.kind != Kind::colour) continue;
    if (auto properties = properties_of(element, group); !properties.empty()) return properties;
  }
  return {};
}

bool is_byte_colour(PlyType type) {
  return ply_is_integer(type) && type != PlyType::uint16;
}

float ply_colour_component(PlyType type, double value, MeshBuilder& builder) {
  if (!ply_is_integer(type)) return builder.component(value);
  if (type == PlyType::uint16) return static_cast<float>(value) / 65535.0F;
  // Text may say anything, a number that is none included.
  const double byte = std::isfinite(value) ? std::clamp(value, 0.0, 255.0) : 0.0;
  return from_byte(static_cast<std::uint8_t>(std::lround(byte)));
}

PlyColumns::PlyColumns(const PlyElement& vertex, bool texture_at_corners, MeshBuilder& builder)
    : builder_(builder), targets_(vertex.properties.size()) {
  const char* const axes[] = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t property = find(vertex, axes[axis]);
    if (property == not_found) throw Fault("the vertices lack x, y or z");
    const PlyType type = vertex.properties[property].type;
    targets_[property] = {What::coordinate, 0, axis, type};
    single_precision_ = single_precision_ && type == PlyType::float32;
  }
  for (const Group& group : groups) {
    if (has_kind(attributes_, group.kind)) continue;
    if (const auto properties = properties_of(vertex, group); !properties.empty())
      take_group(vertex, group.kind, properties, group.kind != Kind::texture || !texture_at_corners);
  }
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const PlyProperty& property = vertex.properties[i];
    if (property.is_list) builder_.ignore("vertex property " + in_quotes(property.name));
    if (property.is_list || targets_[i].what != What::undecided) continue;
    targets_[i] = {What::attribute, attributes_.size(), 0, property.type};
    attributes_.emplace_back().name = property.name;
  }
  rounded_.assign(attributes_.size(), false);
}

void PlyColumns::take_group(const PlyElement& vertex, Kind kind, const std::vector<std::size_t>& properties,
                            bool read) {
  Attribute attribute;
  attribute.kind = kind;
  attribute.components = properties.size();
  attribute.bytes = kind == Kind::colour;
  for (std::size_t k = 0; k < properties.size(); ++k) {
    const PlyType type = vertex.properties[properties[k]].type;
    targets_[properties[k]] = {read ? What::attribute : What::ignored, attributes_.size(), k, type};
    attribute.bytes = attribute.bytes && is_byte_colour(type);
  }
  if (read)
    attributes_.push_back(std::move(attribute));
  else
    builder_.ignore(to_string(attribute) + " of vertices, as the faces have some");
}

void PlyColumns::resize(std::size_t vertices) {
  for (Attribute& attribute : attributes_) attribute.values.resize(vertices * attribute.components);
}

void PlyColumns::set(std::size_t vertex, std::size_t property, double value) {
  const Target& target = targets_[property];
  if (target.what == What::coordinate) {
    point_[target.component] = value;
    return;
  }
  Attribute& attribute = attributes_[target.attribute];
  attribute.values[vertex * attribute.components + target.component] = narrowed(target, value);
}

float PlyColumns::narrowed(const Target& target, double value) {
  const Kind kind = attributes_[target.attribute].kind;
  if (kind == Kind::colour) return ply_colour_component(target.type, value, builder_);
  const float narrow = kind == Kind::scalar ? static_cast<float>(value) : builder_.component(value);
  if (!fits_float(target.type) && std::isfinite(value) && static_cast<double>(narrow) != value)
    rounded_[target.attribute] = true;
  return narrow;
}

attributes::Attributes PlyColumns::take() {
  for (std::size_t i = 0; i < attributes_.size(); ++i)
    if (rounded_[i]) builder_.report().rounded.push_back(to_string(attributes_[i]));
  return std::move(attributes_);
}

}  // namespace whittle::files
