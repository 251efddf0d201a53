/// \file
/// Fills in what describes a set besides its times: counts, errors, pictures.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "experiment/SetMaker.hh"
#include "experiment/Views.hh"
#include "render/HeatPainter.hh"
#include "render/Image.hh"
#include "render/Renderer.hh"
#include "results/Results.hh"

namespace whittle::bench {

/// The pictures of one mesh, before they are files.
struct Pictures {
  render::Image whole, detail;
};

/// Inspects the sets of one experiment. What it is given must outlive it.
class Inspector {
 public:
  /// \param folder  for the pictures; made if missing.
  /// \pre a context is current.
  Inspector(const IndexedMesh& original, const Settings& settings, ExperimentResult& experiment,
            const std::filesystem::path& folder);

  /// Counts, errors and pictures of a set that has been made. A mesh without triangles gets a note instead.
  /// \throw files::FileError  a picture cannot be written.
  void inspect(SetResult& set, const MadeSet& made) const;

  /// The whole model, the detail (not of Paper 2's model) and, but for the original, the heat map, as files
  /// in `folder`/pictures.
  /// \throw files::FileError
  void take_pictures(SetResult& set, const IndexedMesh& mesh) const;

 private:
  std::vector<render::Image> draw_views(const IndexedMesh& mesh) const;
  /// \param flipped_faces  against the nearest original face: peers do not report which face came from which
  Fidelity fidelity(const IndexedMesh& mesh, std::size_t& flipped_faces) const;
  std::string write(const SetResult& set, const std::string& kind, const render::Image& image) const;

  const IndexedMesh& original_;
  const Settings& settings_;
  ExperimentResult& experiment_;
  std::filesystem::path folder_;
  render::Renderer renderer_;
  render::HeatPainter heat_painter_;
  std::vector<render::Camera> around_;
  std::vector<render::Image> original_views_;
};

}  // namespace whittle::bench
