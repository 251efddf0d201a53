/// \file
/// What a result of a textured model is worth.
#pragma once

#include <cstddef>
#include <optional>

#include "attributes/TextureError.hh"
#include "attributes/ValueError.hh"
#include "speed/textured/TexturedModel.hh"

namespace whittle::speed {

struct Worth {
  std::size_t faces = 0;
  double rms = 0;  ///< two-sided distance from the original, in ten-thousandths of its diagonal
  std::optional<attributes::TextureError> texture;  ///< in texels of 1,024
  std::optional<attributes::ValueError> colours;    ///< in 255ths of a component
  std::size_t components = 0, boundary_loops = 0;
  long euler_characteristic = 0;
  std::size_t nonmanifold_edges = 0;

  /// Whether components, Euler characteristic and boundary loops are those of the other, and no edge is not manifold.
  bool has_topology_of(const Worth& other) const {
    return components == other.components && boundary_loops == other.boundary_loops &&
           euler_characteristic == other.euler_characteristic && nonmanifold_edges == 0;
  }
};

/// The counts alone.
Worth topology(const IndexedMesh& mesh);

/// \param samples  of each measurement
/// \throw InvalidMesh  nothing with an area is left
Worth worth(const TexturedModel& original, const IndexedMesh& mesh, const attributes::Attributes& attributes,
            std::size_t samples);

}  // namespace whittle::speed
