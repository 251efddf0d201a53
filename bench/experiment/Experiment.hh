/// \file
/// The experiment of the papers: time many frames of every set, several times over.
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <vector>

#include "render/Camera.hh"
#include "render/Renderer.hh"
#include "results/Results.hh"
#include "terminal/Progress.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::bench {

/// Thrown by time_sets when a stop was requested.
class Stopped : public std::runtime_error {
 public:
  Stopped() : std::runtime_error("interrupted") {}
};

/// The order in which a repetition visits the sets: each one begins a set later than the one before, so that
/// no set always comes first or always after the same long one.
std::vector<std::size_t> visiting_order(std::size_t sets, std::size_t repetition);

/// The sets that repetition `repetition` (from 1) still has to visit, in order. Where an earlier start of the
/// program left a repetition unfinished, the original is visited once more: times of different starts are not
/// compared with one another.
std::vector<std::size_t> missing_visits(const ExperimentResult& experiment, std::size_t repetition);

/// What time_sets reports to, and what can stop it.
struct Watch {
  terminal::Progress& progress;
  std::function<void()> visited;  ///< after every visit, to save the results
  std::function<bool()> stop;     ///< called at every frame
};

/// Times the frames of every set in every repetition and notes the visits down, those that are not there yet.
/// Sets without triangles are left out.
/// \param meshes  one for each set of the experiment, in its order.
/// \param start  number of this start of the program.
/// \throw Stopped
void time_sets(const render::Renderer& renderer, const render::Camera& camera, const Settings& settings,
               const std::vector<const IndexedMesh*>& meshes, std::size_t start, ExperimentResult& experiment,
               const Watch& watch);

}  // namespace whittle::bench
