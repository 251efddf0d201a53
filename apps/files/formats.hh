/// \file
/// One reader and one writer for each format. All of them throw Fault.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "files/MeshFile.hh"

namespace whittle::files {

/// Readers keep `line` at the line they are on, for the error message; 0 where the file is not text.
/// \{
MeshFile read_obj(std::string_view bytes, std::size_t& line);
MeshFile read_off(std::string_view bytes, std::size_t& line);
MeshFile read_ply(std::string_view bytes, std::size_t& line);
MeshFile read_stl(std::string_view bytes, std::size_t& line);
/// \}

/// True if the content alone says so, whatever the file is called.
/// \{
bool is_off(std::string_view bytes);
bool is_ply(std::string_view bytes);
/// \}

/// Writers expect what check_mesh (write.cc) has let through: indices in range, coordinates finite.
/// \{
std::string obj_bytes(const IndexedMesh& mesh, const WriteOptions& options);
std::string off_bytes(const IndexedMesh& mesh, const WriteOptions& options);
std::string ply_bytes(const IndexedMesh& mesh, const WriteOptions& options);
std::string stl_bytes(const IndexedMesh& mesh, const WriteOptions& options);
/// \}

enum class Format { obj, off, ply, stl };

/// The format that the extension names, in any case of letters.
/// \throw Fault  it names none
Format format_of_extension(const std::string& extension);

}  // namespace whittle::files
