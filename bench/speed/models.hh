/// \file
/// The models of a suite.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "speed/lineup.hh"

namespace whittle::speed {

/// Reads the files, or without any the bunny and, if it is there, the dragon from the cache. For the growth
/// suite the last model is subdivided so many times, each step a model of its own.
/// \throw files::FileError, std::runtime_error  a file cannot be read or holds no triangle.
std::vector<Subject> load_models(std::vector<std::filesystem::path> files, const std::filesystem::path& cache,
                                 Suite suite, std::size_t subdivisions);

}  // namespace whittle::speed
