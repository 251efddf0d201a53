/// \file
/// The model that the experiment runs on, and its origin.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/Results.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::bench {

/// Where a model came from: the bunny in the cache of assets, a file the user named, or made up here.
enum class ModelKind { bunny, file, generated };

std::string to_string(ModelKind kind);

struct Model {
  IndexedMesh mesh;
  ModelKind kind = ModelKind::generated;
  std::string label;               ///< stands under every picture and table
  std::string file;                ///< the file's name without its folder; empty for a generated mesh
  double mean_edge = 0;            ///< in model units
  std::vector<std::string> notes;  ///< what a reader of the results has to know; belongs in every output
};

/// Loads `file`, or without one `bunny.*` from the cache, or without that generates a mesh and notes it. A
/// model whose mean edge is far from the bunny's is noted too, since the paper's thresholds then mean
/// something else.
/// \param label  in place of the one that names the model's origin; a generated mesh keeps its own.
/// \throw files::FileError, std::invalid_argument  the file cannot be read or holds no triangles.
Model load_model(const std::optional<std::filesystem::path>& file, const std::filesystem::path& cache,
                 const std::string& label = "");

/// Suzanne, Paper 2's model: `file`, or without one `suzanne.*` from the cache; none where neither is there.
/// \throw files::FileError, std::invalid_argument  as above.
std::optional<Model> load_monkey(const std::optional<std::filesystem::path>& file,
                                 const std::filesystem::path& cache);

/// What the results say of a model.
ModelFacts facts(const Model& model);

}  // namespace whittle::bench
