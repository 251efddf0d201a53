/// \file
/// What a code block leaves, as OpenMesh writes it and reads it back.
#pragma once

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstddef>
#include <string>

#include "Folder.hh"
#include "catch.hh"

namespace written {

/// The mesh written as a file of this extension and read back.
template <typename Mesh>
Mesh read_back(const Mesh& mesh, const std::string& extension,
               OpenMesh::IO::Options options = OpenMesh::IO::Options::Default) {
  const scratch::Folder folder;
  const std::string path = (folder / ("left" + extension)).string();
  REQUIRE(OpenMesh::IO::write_mesh(mesh, path, options));
  Mesh out;
  if (options.check(OpenMesh::IO::Options::VertexColor)) out.request_vertex_colors();
  REQUIRE(OpenMesh::IO::read_mesh(out, path, options));
  return out;
}

/// The mesh has this number of faces, nothing in it is marked as deleted, and files of it have as many.
template <typename Mesh>
void check_faces(const Mesh& mesh, std::size_t n_faces) {
  CHECK(mesh.n_faces() == n_faces);
  for (const char* extension : {".ply", ".off"}) {
    INFO("as " << extension);
    const Mesh read = read_back(mesh, extension);
    CHECK(read.n_faces() == n_faces);
    CHECK(read.n_vertices() == mesh.n_vertices());
  }
}

}  // namespace written
