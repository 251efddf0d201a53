/// \file
/// Planners one after the other, each on the surface that those before it leave, in one plan.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "whittle/CollapsePlan.hh"
#include "whittle/Surface.hh"
#include "whittle/execute.hh"

namespace whittle {

/// Draws up a plan in stages. The flip guard of every stage judges a face by its normal in the input, so no
/// chain of stages turns a face further than one stage may.
template <typename Real>
class StagesT {
 public:
  /// \param input  must outlive this.
  explicit StagesT(const SurfaceT<Real>& input)
      : input_(input), faces_(input.n_faces()), vertices_(input.n_vertices()) {}

  /// Plans a stage; its collapses come after those of the stages before it.
  /// \return how many collapses it added.
  template <typename Planner>
  std::size_t add(const Planner& planner) {
    CollapsePlan stage = planner.plan(surface());
    const std::size_t before = plan_.collapses.size();
    if (!stage.collapses.empty())
      for (const std::size_t begin : stage.stages) plan_.stages.push_back(before + begin);
    for (Collapse collapse : stage.collapses) {
      faces_ -= collapse.faces;
      --vertices_;
      collapse.from = input_vertex(collapse.from);
      collapse.to = input_vertex(collapse.to);
      plan_.collapses.push_back(collapse);
    }
    plan_.record += stage.record;
    if (!stage.collapses.empty()) pending_ = std::move(stage);
    return plan_.collapses.size() - before;
  }

  std::size_t n_faces() const { return faces_; }        ///< that the plan so far leaves
  std::size_t n_vertices() const { return vertices_; }  ///< isolated ones included

  CollapsePlan take() {
    if (plan_.stages.empty()) plan_.stages.push_back(0);
    return std::move(plan_);
  }

 private:
  std::uint32_t input_vertex(std::uint32_t v) const { return current_ ? vertex_[v] : v; }

  /// The surface as the stages so far leave it.
  const SurfaceT<Real>& surface();

  const SurfaceT<Real>& input_;
  std::size_t faces_, vertices_;
  CollapsePlan plan_;
  CollapsePlan pending_;  // the last stage, in the indices of the surface that it was planned on
  std::unique_ptr<IndexedMeshT<Real>> mesh_;
  std::unique_ptr<SurfaceT<Real>> current_;   // null: the input
  std::vector<std::uint32_t> vertex_, face_;  // of the current surface, in the input
};

template <typename Real>
const SurfaceT<Real>& StagesT<Real>::surface() {
  if (pending_.collapses.empty()) return current_ ? *current_ : input_;
  const SurfaceT<Real>& last = current_ ? *current_ : input_;
  auto executed = execute(pending_, last.mesh());
  pending_ = {};

  std::vector<std::uint32_t> vertex(executed.mesh.points.size());
  for (std::uint32_t v = last.n_vertices(); v-- > 0;)
    if (executed.survives[v]) vertex[executed.vertex_map[v]] = input_vertex(v);
  std::vector<std::uint32_t> face(std::move(executed.face_origin));
  if (current_)
    for (std::uint32_t& f : face) f = face_[f];

  constexpr std::uint8_t kUsers = kLocked | kFeature | kSeam;
  SurfaceExtras extras;
  for (const std::uint32_t v : vertex) {
    extras.flags.push_back(input_.flags(v) & kUsers);
    if (!input_.extras().tolerance.empty()) extras.tolerance.push_back(input_.extras().tolerance[v]);
  }
  for (const std::uint32_t f : face) extras.reference_normals.push_back(input_.reference_normal(f));
  auto mesh = std::make_unique<IndexedMeshT<Real>>(std::move(executed.mesh));
  current_ = std::make_unique<SurfaceT<Real>>(*mesh, std::move(extras));
  mesh_ = std::move(mesh);
  vertex_ = std::move(vertex);
  face_ = std::move(face);
  return *current_;
}

/// A planner repeated until nothing changes, at most `max_passes` times.
/// \tparam Enough  called with the stages after each pass; true ends the passes.
template <typename Planner, typename Real, typename Enough>
CollapsePlan plan_passes(const Planner& planner, const SurfaceT<Real>& surface, std::size_t max_passes,
                         Enough enough) {
  StagesT<Real> stages(surface);
  for (std::size_t pass = 0; pass < max_passes; ++pass)
    if (stages.add(planner) == 0 || enough(stages)) break;
  return stages.take();
}

}  // namespace whittle
