#!/usr/bin/env bash
# Configures and builds a project whose CMakeLists.txt is a block of a page, beside a copy of Whittle in the folder
# `whittle` and with a package of it to be found.
#   project.sh CMAKE GENERATOR SOURCE BUILD BLOCK
set -euo pipefail
cmake=$1 generator=$2 source=$3 build=$4 block=$5

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$cmake" --install "$build" --prefix "$folder/prefix" --component modules >/dev/null

mkdir "$folder/project"
ln -s "$source" "$folder/project/whittle"
{
  echo 'cmake_minimum_required(VERSION 3.22)'
  echo 'project(your_project LANGUAGES CXX)'
  echo 'add_executable(your_program main.cc)'
  cat "$block"
} >"$folder/project/CMakeLists.txt"
cat >"$folder/project/main.cc" <<'END'
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <whittle/compact.hh>

int main() {
  OpenMesh::TriMesh_ArrayKernelT<> mesh;
  whittle::compact(mesh);
  return static_cast<int>(mesh.n_faces());
}
END
"$cmake" -S "$folder/project" -B "$folder/build" -G "$generator" -DCMAKE_PREFIX_PATH="$folder/prefix" \
  -DFETCHCONTENT_SOURCE_DIR_WHITTLE="$source" -Werror=dev
"$cmake" --build "$folder/build" --target your_program
"$folder/build/your_program"
