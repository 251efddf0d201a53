/// \file
/// Filling a mesh with what a reader found; the rules that all formats share stand here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "files/MeshFile.hh"

namespace whittle::files {

/// \throw Fault  not finite
void add_point(MeshFile& file, double x, double y, double z);

/// Splits the face into a fan and leaves out triangles that name a vertex twice; counts both.
/// \throw Fault  fewer than three corners
void add_face(MeshFile& file, const std::vector<std::uint32_t>& corners);

/// Notes an attribute that is not read, once.
void ignore(MeshFile& file, const std::string& attribute);

/// A vertex index that counts from 0, checked.
/// \throw Fault  not below `vertices`
std::uint32_t checked_index(std::int64_t index, std::size_t vertices);

/// \param index  as it stands in the file, for the message
[[noreturn]] void throw_index_out_of_range(std::int64_t index, std::size_t vertices);

/// To be called before memory is reserved for `count` things that take at least `least_bytes` each.
/// \param remaining  bytes of the file that are left to read
/// \throw Fault  the file cannot hold so many
void check_declared(std::uint64_t count, const std::string& things, std::size_t least_bytes,
                    std::size_t remaining);

}  // namespace whittle::files
