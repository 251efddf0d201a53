/// \file
/// What a session holds: the mesh that was opened, what a recipe made of it, and how far the two lie apart.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "files/MeshFile.hh"
#include "measure/Distance.hh"
#include "measure/MeshFacts.hh"
#include "model/EdgeTable.hh"
#include "model/Histogram.hh"
#include "model/PlanPicture.hh"
#include "recipe/Progression.hh"
#include "recipe/Recipe.hh"
#include "render/MeshBuffers.hh"

namespace whittle::viewer {

/// Facts of one mesh.
struct Inspection {
  measure::MeshFacts facts;
  EdgeSets edges;
  std::array<std::vector<float>, 3> values;  ///< by Quantity

  const std::vector<float>& of(Quantity quantity) const { return values[static_cast<std::size_t>(quantity)]; }
};
Inspection inspect(const IndexedMesh& mesh);

/// The histograms of each quantity.
/// \param result  null if there is none.
std::array<HistogramPair, 3> histograms(const Inspection& original, const Inspection* result);

/// A mesh file that is open.
struct Model {
  std::string path;
  files::MeshFile file;
  recipe::Scale scale;
  Inspection inspection;
  std::array<HistogramPair, 3> histograms;  ///< by Quantity, without a result
  std::optional<render::MeshArrays> arrays;

  const IndexedMesh& mesh() const { return file.mesh; }
  /// Attributes and parts are carried over, and seams move or stay, as on the command line.
  recipe::Givens givens() const {
    return {{}, {}, &file.attributes, {}, file.parts.areas(), 0, &file.parts.of_face};
  }
  Eigen::AlignedBox3d box() const { return {inspection.facts.box_min, inspection.facts.box_max}; }
};

/// \throw FileError  as read_mesh(), and for a mesh without faces.
std::shared_ptr<const Model> load_model(const std::string& path);

/// The plan for all levels of a model, made when the first level is requested. For one thread.
using Levels = std::optional<recipe::Progression>;

/// What a recipe made of a model.
struct Outcome {
  std::shared_ptr<const Model> model;
  recipe::Recipe recipe;
  recipe::Result result;
  bool from_levels = false;  ///< out of the plan for all levels
  double milliseconds = 0;   ///< planning and execution, as the command line counts them
  std::optional<render::MeshArrays> arrays;

  const IndexedMesh& mesh() const { return result.mesh; }
  double faces_removed() const;  ///< of all, 0..1
};

/// Runs a recipe. The result is rounded as the exported file will be, so that what is measured is what is
/// written. Throws what recipe::run() throws.
std::shared_ptr<const Outcome> make_outcome(std::shared_ptr<const Model> model, const recipe::Recipe& recipe,
                                            const recipe::Monitor& monitor = {});

/// The same out of the plan for all levels.
/// \pre has_levels(recipe)
std::shared_ptr<const Outcome> make_level(std::shared_ptr<const Model> model, const recipe::Recipe& recipe,
                                          Levels& levels, const recipe::Monitor& monitor = {});

/// How an outcome compares with its model.
struct Comparison {
  std::shared_ptr<const Outcome> outcome;
  Inspection inspection;                      ///< of the result
  std::array<HistogramPair, 3> histograms;    ///< of both, by Quantity
  std::optional<measure::Distance> distance;  ///< none where one of the meshes has no area
  /// For each vertex of the original its distance to the result. For each vertex of the result the largest of
  /// its own distance to the original and those of the vertices that became it, so that a surface whose
  /// vertices all lie on the original still shows what it lost.
  std::vector<float> original_heat, result_heat;
  double heat_top = 0;  ///< a good upper end for a scale of colours: nearly all vertices lie below
};

}  // namespace whittle::viewer
