/// \file
/// The suite `textured`: mq on models with texture coordinates or colours, and what other programs made of them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "speed/json.hh"
#include "speed/textured/TexturedModel.hh"
#include "terminal/Progress.hh"

namespace whittle::speed {

struct TexturedSettings {
  std::size_t rounds = 3;        ///< how often each run is timed
  std::size_t samples = 100000;  ///< of each measurement
  /// Results of others: PEER/MODEL-PERCENT.glb (or any other format) in it, as in gltfpack/sphere-6-10.glb
  std::optional<std::filesystem::path> peers;
  std::filesystem::path pictures;  ///< folder for the PNGs, beside the page
};

/// Decimates each model to 50, 25, 10, 5 and 2 % of its faces and says what the results are worth; docs/speed.md
/// describes the fields.
Json run_textured(const std::vector<TexturedModel>& models, const TexturedSettings& settings,
                  terminal::Progress& progress);

/// Writes each model as MODEL.glb into a folder, for other programs.
void export_textured(const std::vector<TexturedModel>& models, const std::filesystem::path& folder);

/// The suite's part of a page.
/// \param suite  one of a run's suites
void write_textured(std::ostream& out, const Json& suite);

}  // namespace whittle::speed
