/// \file
/// The one form in which readers hand attributes over.
#pragma once

#include <cstdint>
#include <vector>

#include "files/MeshFile.hh"

namespace whittle::files {

/// What a vertex or a corner gets to which the file gives no value: white and opaque, or zero.
float default_component(attributes::Kind kind);

/// Stores an attribute with values at corners per vertex if the corners of each vertex agree, else each
/// distinct value once, in the order in which the corners use them. Corners with `no_value` get a default.
/// \param of_vertex  the values of vertices that no face uses; empty: a default
/// \return how many corners had no value
/// \pre every face and value index is in range
std::size_t settle(attributes::Attribute& attribute, const IndexedMesh& mesh,
                   const std::vector<std::uint32_t>& of_vertex = {});

/// Settles all attributes that have values at corners, and counts what was missing.
/// \pre every face's index is in range
void settle(MeshFile& file);

}  // namespace whittle::files
