/// \file
/// The numbers behind the coordinates of OBJ's vertices.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "attributes/Attribute.hh"
#include "files/Choice.hh"

namespace whittle::files {

/// A vertex is `x y z`, then a colour `r g b`, `r g b a`, `w r g b` or `w r g b a`, where w is a weight that polygons
/// have no use for. So four numbers may be either: they are `w r g b` where the first of them is 1 at every vertex.
class ObjColours {
 public:
  bool empty() const { return values_.empty(); }

  /// \param numbers  five, of which the first `count`, 3 to 5, stand in the file and the others are 1
  /// \param vertex   whose they are; those before it that had none are white
  void add(const float* numbers, std::size_t count, std::size_t vertex) {
    values_.resize(4 * vertex, 1.0F);
    missing_ += vertex - coloured_end_;
    coloured_end_ = vertex + 1;
    if (count == 5) ++numbers;
    values_.insert(values_.end(), numbers, numbers + 4);
    if (count >= 4) components_ = 4;
    have_weights_ = have_weights_ && count == 4 && numbers[0] == 1.0F;
  }

  /// Four numbers are a weight and a colour.
  bool have_weights() const { return have_weights_; }

  /// \param missing  raised by how many vertices had no colour
  attributes::Attribute take(std::size_t vertices, std::size_t& missing) const {
    attributes::Attribute colour;
    colour.kind = attributes::Kind::colour;
    colour.components = have_weights_ ? 3 : components_;
    const std::size_t first = have_weights_ ? 1 : 0;
    for (std::size_t i = 0; i < values_.size(); i += 4)
      for (std::size_t k = 0; k < colour.components; ++k) colour.values.push_back(values_[i + first + k]);
    if (colour.components == 3 && are_up_to_255(colour.values))
      for (float& value : colour.values) value = from_byte(to_byte(value / 255.0F));
    colour.values.resize(vertices * colour.components, 1.0F);
    colour.bytes = are_bytes(colour.values);
    missing += missing_ + vertices - coloured_end_;
    return colour;
  }

 private:
  /// Whole numbers of which some are larger than any colour of 0..1.
  static bool are_up_to_255(const std::vector<float>& values) {
    bool any_larger = false;
    for (const float value : values) {
      if (!(value >= 0 && value <= 255 && std::floor(value) == value)) return false;
      any_larger = any_larger || value > 1;
    }
    return any_larger;
  }

  /// True if every value is one of 256 and keeps its bits as such.
  static bool are_bytes(const std::vector<float>& values) {
    return std::all_of(values.begin(), values.end(),
                       [](float value) { return from_byte(to_byte(value)) == value; });
  }

  std::vector<float> values_;  ///< four for each vertex up to the last one with a colour
  std::size_t components_ = 3;
  std::size_t coloured_end_ = 0;
  std::size_t missing_ = 0;
  bool have_weights_ = true;
};

}  // namespace whittle::files
