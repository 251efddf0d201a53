/// \file
/// What the properties of PLY's vertices mean.
#pragma once

#include <cstddef>
#include <vector>

#include "files/MeshBuilder.hh"
#include "files/ply_header.hh"

namespace whittle::files {

/// The properties that are a colour together, in their order; empty: there is none.
std::vector<std::size_t> ply_colour_properties(const PlyElement& element);

/// Whether its values are kept exactly as bytes.
bool is_byte_colour(PlyType type);

/// A component of a colour, from 0..255, 0..65535 or a floating-point number.
float ply_colour_component(PlyType type, double value, MeshBuilder& builder);

/// Where each property's value goes, and the attributes that come of it.
class PlyColumns {
 public:
  /// \param texture_at_corners  the faces have texture coordinates, so those of the vertices are not read
  /// \throw Fault  x, y or z is missing
  PlyColumns(const PlyElement& vertex, bool texture_at_corners, MeshBuilder& builder);

  /// Makes room for the values of so many vertices.
  void resize(std::size_t vertices);

  bool is_read(std::size_t property) const {
    return targets_[property].what == What::coordinate || targets_[property].what == What::attribute;
  }

  /// Takes a property's value for a vertex.
  void set(std::size_t vertex, std::size_t property, double value);

  /// The coordinates that were set last.
  const double* point() const { return point_; }

  bool single_precision() const { return single_precision_; }

  /// The attributes with all their values. Notes which were rounded.
  attributes::Attributes take();

 private:
  enum class What { undecided, coordinate, attribute, ignored };

  struct Target {
    What what = What::undecided;
    std::size_t attribute = 0;
    std::size_t component = 0;
    PlyType type = PlyType::float32;
  };

  void take_group(const PlyElement& vertex, attributes::Kind kind, const std::vector<std::size_t>& properties,
                  bool read);
  float narrowed(const Target& target, double value);

  MeshBuilder& builder_;
  std::vector<Target> targets_;  ///< one for each property
  attributes::Attributes attributes_;
  std::vector<bool> rounded_;  ///< one for each attribute
  double point_[3] = {0, 0, 0};
  bool single_precision_ = true;
};

}  // namespace whittle::files
