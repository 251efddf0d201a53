/// \file
/// The code of tinygltf, which is a header. What it may do (no files, no images) is set in CMakeLists.txt.
#include <fstream>  // which it forgets where it may open no files
#include <nlohmann/json.hpp>

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
