/// \file
/// Colours of PLY's faces, which become those of their corners.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "files/MeshBuilder.hh"
#include "files/PlyColumns.hh"
#include "files/ply_header.hh"

namespace whittle::files {

class PlyFaceColours {
 public:
  /// \param face      whose colours are read where they are complete
  /// \param vertices  whose colours go before, where they have some; null: there are none
  PlyFaceColours(const PlyElement& face, const PlyElement* vertices, MeshBuilder& builder)
      : builder_(builder), properties_(ply_colour_properties(face)) {
    if (properties_.empty()) return;
    is_read_ = vertices == nullptr || ply_colour_properties(*vertices).empty();
    if (!is_read_) builder.ignore("face colours, as the vertices have some");
    colour_.kind = attributes::Kind::colour;
    colour_.components = properties_.size();
    colour_.bytes = true;
    for (const std::size_t property : properties_)
      colour_.bytes = colour_.bytes && is_byte_colour(face.properties[property].type);
  }

  /// Whether a property's values are to be handed to set().
  bool takes(std::size_t property) const { return is_read_ && component(property) < properties_.size(); }

  /// A value of the face at hand.
  void set(std::size_t property, PlyType type, double value) {
    now_[component(property)] = ply_colour_component(type, value, builder_);
  }

  /// Whether a property is part of a colour, read or not.
  bool has(std::size_t property) const { return component(property) < properties_.size(); }

  /// What the corners of the face at hand have, of which all values are there now.
  CornerValues& at_corners(std::size_t corners) {
    of_.face.clear();
    if (is_read_) {
      of_.face.assign(corners, static_cast<std::uint32_t>(colour_.n_values()));
      colour_.values.insert(colour_.values.end(), now_, now_ + colour_.components);
    }
    return of_;
  }

  /// Those of all corners so far.
  CornerValues& all() { return of_; }
  attributes::Attribute take() { return std::move(colour_); }

 private:
  std::size_t component(std::size_t property) const {
    std::size_t k = 0;
    while (k < properties_.size() && properties_[k] != property) ++k;
    return k;
  }

  MeshBuilder& builder_;
  std::vector<std::size_t> properties_;  ///< red, green, blue and maybe alpha
  bool is_read_ = false;
  attributes::Attribute colour_;
  float now_[4] = {0, 0, 0, 0};
  CornerValues of_;
};

}  // namespace whittle::files
