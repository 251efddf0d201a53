/// \file
/// The experiment of the paper: decimate, take pictures, time a thousand frames, several times over.
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <vector>

#include "experiment/Model.hh"
#include "experiment/Sets.hh"
#include "measure/MeshFacts.hh"
#include "render/Camera.hh"
#include "render/FrameTimer.hh"
#include "render/Image.hh"
#include "render/Renderer.hh"
#include "report/Progress.hh"

namespace whittle::bench {

struct Settings {
  int width = 512, height = 512;  ///< of the timed image, in pixels
  render::FrameRange frames;
  std::size_t repetitions = 10;  ///< as many as the paper's
};

/// One visit to a set: when in its repetition, counted from 1, and how long the frames took.
struct Visit {
  std::size_t place = 0;
  render::SpanTime time;
};

/// One set with everything found out about it.
struct SetResult {
  SetDefinition definition;
  IndexedMesh mesh;
  measure::MeshFacts facts;
  std::size_t flipped_faces = 0;
  std::vector<Visit> visits;  ///< one for each repetition
};

/// Thrown out of time_sets when it was asked to stop.
class Stopped : public std::runtime_error {
 public:
  Stopped() : std::runtime_error("interrupted") {}
};

/// The mesh of one set. The original is drawn as it is in the file, in the file's order.
SetResult decimate(const IndexedMesh& original, const SetDefinition& definition);

/// The two views, the same for all sets: they come from the original's box.
struct Views {
  render::Camera whole;
  render::Camera ears;  ///< the upper front part of the box, where the bunny's ears are
};
Views views(const IndexedMesh& original, double aspect);

/// The two pictures of a set, with smoothed edges.
struct Pictures {
  render::Image whole, ears;
};
Pictures take_pictures(const render::Renderer& renderer, const Views& views, const IndexedMesh& mesh,
                       int width, int height);

/// The order in which a repetition visits the sets: each one begins a set later than the one before, so that
/// no set always comes first or always after the same long one.
std::vector<std::size_t> visiting_order(std::size_t sets, std::size_t repetition);

/// Times the frames of every set in every repetition and notes the visits down in the sets.
/// \param stop  asked at every frame.
/// \throw Stopped
void time_sets(const render::Renderer& renderer, const render::Camera& camera, const Settings& settings,
               std::vector<SetResult>& sets, Progress& progress, const std::function<bool()>& stop);

}  // namespace whittle::bench
