/// \file
/// A torus in a file, in a folder that holds nothing else.
#pragma once

#include <string>

#include "Process.hh"
#include "files/MeshFile.hh"
#include "meshes.hh"

namespace programs {

struct TorusFile {
  explicit TorusFile(const std::string& name = "in.ply") : path(folder / name) {
    whittle::files::write_mesh(path, mesh);
  }
  Folder folder;
  whittle::IndexedMesh mesh = meshes::shaken(meshes::torus(48, 28), 0.003, 1);
  std::string path;
};

/// Runs the command line.
inline Outcome whittle_program(const std::vector<std::string>& arguments) {
  return run(WHITTLE_PROGRAM, arguments);
}

}  // namespace programs
