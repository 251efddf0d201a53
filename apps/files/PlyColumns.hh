/// \file
/// What the properties of PLY's vertices mean.
#pragma once

#include <cstddef>
#include <vector>

#include "files/MeshBuilder.hh"
#include "files/ply_header.hh"

namespace whittle::files {

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

  struct Group;
  static const Group groups[];

  void take_group(const PlyElement& vertex, const Group& group, bool read);
  std::size_t find(const PlyElement& vertex, std::string_view name) const;
  float narrowed(const Target& target, double value);

  MeshBuilder& builder_;
  std::vector<Target> targets_;  ///< one for each property
  attributes::Attributes attributes_;
  std::vector<bool> rounded_;  ///< one for each attribute
  double point_[3] = {0, 0, 0};
  bool single_precision_ = true;
};

}  // namespace whittle::files
