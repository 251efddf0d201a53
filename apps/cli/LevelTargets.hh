/// \file
/// How many faces the levels of detail are to have.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace whittle::cli {

struct LevelTargets {
  std::optional<double> step;       ///< the faces of a level as a part of the one before
  std::vector<double> ratios;       ///< of each level behind the model, as a part of the model
  std::vector<std::size_t> counts;  ///< of each level behind the model

  /// How many levels are listed, without the model; 0 where there is only a step.
  std::size_t size() const { return ratios.size() + counts.size(); }

  /// At least 1. \param level  from 1
  std::size_t faces_of(std::size_t level, std::size_t faces_of_model) const;
};

/// \param ratios  one, the step from level to level, or several with commas
/// \param counts  one or several with commas; empty: the ratios count
/// \throw recipe::RecipeError  a level is not smaller than the one before
LevelTargets parse_levels(const std::string& ratios, const std::string& counts);

}  // namespace whittle::cli
