/// \file
/// The module that `decimate` runs.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "whittle/openmesh/DecimateOptions.hh"
#include "whittle/openmesh/ModPlannedT.hh"
#include "whittle/openmesh/describe.hh"
#include "whittle/plan/SeamRecord.hh"
#include "whittle/plan/TargetCount.hh"
#include "whittle/planners/PieceChoice.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/doubled.hh"
#include "whittle/surface/errors.hh"

namespace whittle::detail {

/// The module that `decimate` adds to its sweep.
template <typename MeshT, typename Planner>
class ModDecimateT : public ModPlannedT<MeshT, Planner> {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<ModDecimateT>;
  DECIMATER_MODNAME(Decimate)

  explicit ModDecimateT(MeshT& mesh) : ModPlannedT<MeshT, Planner>(mesh) {}

  void set_options(const DecimateOptions& options, const TargetCount& target) {
    options_ = &options;
    target_ = target;
    this->set_enough(target.faces, target.vertices);
  }
  /// How far to go, from `initialize()` on: the target, raised for the sake of what is free, and the pieces that vanish at
  /// the end.
  const TargetCount& target() const { return target_; }

  /// Vertices on open edges at exactly the place of others.
  std::size_t n_doubled() const { return n_doubled_; }

  /// Deletes the pieces that vanish as a whole.
  void remove_pieces(DecimateReport& report) {
    report.attainable = choice_.attainable;
    report.pieces_gone = choice_.n_gone();
    if (choice_.goes.empty()) return;
    MeshT& mesh = this->mesh();
    for (const auto f : mesh.faces())  // without deleted ones
      if (choice_.has_gone(static_cast<std::size_t>(mesh.fv_iter(f)->idx()))) mesh.delete_face(f, false);
    for (const auto v : mesh.vertices()) {
      if (!choice_.has_gone(static_cast<std::size_t>(v.idx()))) continue;
      mesh.delete_vertex(v, false);
      --report.vertices;
    }
    report.faces -= choice_.faces_gone();
  }
  /// Fills in what the mesh held, and which charts have no face left.
  void count(bool seams_move, DecimateReport& report) {
    std::vector<std::uint32_t> left;
    if (!seams_.empty())
      for (const auto f : this->mesh().faces())  // without deleted ones
        left.push_back(static_cast<std::uint32_t>(f.idx()));
    detail::count(flags_, seams_, seams_move, left, report);
  }

 protected:
  void describe(const MeshT& mesh, const IndexedMeshT<typename MeshT::Scalar>& indexed,
                SurfaceExtras& extras) override {
    add_locks(indexed, *options_, extras.flags);
    if (options_->lock_selected)
      for (const auto v : mesh.vertices())  // without deleted ones
        if (mesh.status(v).selected()) extras.flags[static_cast<std::size_t>(v.idx())] |= kLocked;
    if (options_->weight.is_valid()) add_weights(mesh, extras.tolerance);
    add_values(mesh, options_->values, extras);
    flags_ = extras.flags;
    n_doubled_ = count_doubled(indexed);
    seams_ = {};
    if (const auto& seams = this->attributes().seams(); !seams.empty()) {
      seams_.charts = this->attributes().charts();
      for (std::size_t v = 0; v < mesh.n_vertices(); ++v)
        seams_.on_seam.push_back(seams.is_on_seam(typename MeshT::VertexHandle(static_cast<int>(v))));
    }
    choose(mesh, indexed, extras);
  }

 private:
  /// Chooses the pieces that vanish, locks them, and sets the target of the others. Deleted vertices count as isolated ones
  /// of the plan's input, but not towards the target.
  void choose(const MeshT& mesh, const IndexedMeshT<typename MeshT::Scalar>& indexed, SurfaceExtras& extras) {
    const auto living = mesh.vertices();
    const std::size_t n_deleted =
        mesh.n_vertices() - static_cast<std::size_t>(std::distance(living.begin(), living.end()));
    TargetCount target = target_;
    if (target.vertices > 0) target.vertices += n_deleted;
    std::vector<ChartSize> kept;
    if (!seams_.empty() && keeps_charts(this->planner()))
      kept = chart_sizes(seams_.charts, this->attributes().input().triangles);
    choice_ = choose_pieces(this->planner(), indexed, extras, seams_, kept, *options_, target);
    target_ = choice_.target_with_pieces();
    if (target_.vertices > 0) target_.vertices -= n_deleted;
    this->set_enough(target_.faces, target_.vertices);
    this->set_planner(with_target(this->planner(), target_));
  }

  /// A threshold that is f times as large lets an error count 1 / f^2 as much.
  void add_weights(const MeshT& mesh, std::vector<float>& tolerance) const {
    tolerance.resize(mesh.n_vertices(), 1);
    for (const auto v : mesh.vertices()) {  // without deleted ones
      const float weight = mesh.property(options_->weight, v);
      if (!(weight > 0 && weight <= std::numeric_limits<float>::max()))
        throw InvalidParameter("vertex " + std::to_string(v.idx()) +
                               " has a weight that is not positive and finite");
      tolerance[static_cast<std::size_t>(v.idx())] /= std::sqrt(weight);
    }
  }

  const DecimateOptions* options_ = nullptr;
  TargetCount target_;
  PieceChoice choice_;
  std::vector<std::uint8_t> flags_;
  std::size_t n_doubled_ = 0;
  SeamRecord seams_;  // its charts are those of the mesh's faces, deleted ones included
};

}  // namespace whittle::detail
