/// \file
/// Planners one after the other, each on the surface that those before it leave, in one plan.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "whittle/plan/CollapsePlan.hh"
#include "whittle/plan/TargetCount.hh"
#include "whittle/plan/execute.hh"
#include "whittle/plan/merged_wedges.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/errors.hh"

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
    plan_.record += stage.record;
    const std::size_t before = plan_.collapses.size(), added = stage.collapses.size();
    if (added == 0) return 0;
    for (const Collapse& collapse : stage.collapses) faces_ -= collapse.faces;
    vertices_ -= added;
    for (const std::size_t begin : stage.stages) plan_.stages.push_back(before + begin);
    is_pending_ = true;
    if (!current_) {
      plan_.collapses = std::move(stage.collapses);
      return added;
    }
    plan_.collapses.reserve(before + added);
    for (Collapse collapse : stage.collapses) {
      collapse.from = vertex_[collapse.from];
      collapse.to = vertex_[collapse.to];
      plan_.collapses.push_back(collapse);
    }
    pending_ = std::move(stage);
    return added;
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
  bool is_pending_ = false;  // whether the current surface does not yet know of the last stage
  CollapsePlan pending_;     // which is here in that surface's indices; the first stage is `plan_` itself
  std::unique_ptr<IndexedMeshT<Real>> mesh_;
  std::unique_ptr<SurfaceT<Real>> current_;   // null: the input
  std::vector<std::uint32_t> vertex_, face_;  // of the current surface, in the input
};

template <typename Real>
const SurfaceT<Real>& StagesT<Real>::surface() {
  const SurfaceT<Real>& last = current_ ? *current_ : input_;
  if (!is_pending_) return last;
  auto executed = execute(current_ ? pending_ : plan_, last.mesh());
  is_pending_ = false;
  pending_ = {};

  std::vector<std::uint32_t> vertex(executed.mesh.points.size());
  for (std::uint32_t v = last.n_vertices(); v-- > 0;)
    if (executed.survives[v]) vertex[executed.vertex_map[v]] = input_vertex(v);
  SurfaceExtras extras;
  const auto& wedges = last.extras().wedges;
  if (!wedges.empty())
    extras.wedges = merged_wedges({last.mesh().triangles, executed.mesh.triangles, executed.vertex_map,
                                   executed.face_origin, executed.mesh.points.size()},
                                  wedges);
  std::vector<std::uint32_t> face(std::move(executed.face_origin));
  if (current_)
    for (std::uint32_t& f : face) f = face_[f];

  // Where there are wedges, they say anew who is on a seam.
  const std::uint8_t users = wedges.empty() ? kLocked | kFeature | kSeam : kLocked | kFeature;
  for (const std::uint32_t v : vertex) {
    extras.flags.push_back(input_.flags(v) & users);
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

namespace detail {

/// What a planner answers to `question`, or `otherwise` if it has no such member.
/// \tparam Question  a generic lambda whose trailing return type names the member
template <typename Planner, typename Question>
bool answer(const Planner& planner, Question question, bool otherwise) {
  if constexpr (std::is_invocable_v<Question, const Planner&>) return question(planner);
  return otherwise;
}

/// Whether a planner stops by itself: one with a threshold does, one that says otherwise by `has_end()` does not.
template <typename Planner>
bool has_end(const Planner& planner) {
  return answer(
      planner, [](const auto& p) -> decltype(p.has_end()) { return p.has_end(); }, true);
}

/// Whether a planner merges vertices along seams: one that says so by `moves_seams()` does, others hold them.
template <typename Planner>
bool moves_seams(const Planner& planner) {
  return answer(
      planner, [](const auto& p) -> decltype(p.moves_seams()) { return p.moves_seams(); }, false);
}

/// Whether what a planner makes of a mesh is refitted to it unless told otherwise: one that says so by `refits()`.
template <typename Planner>
bool refits(const Planner& planner) {
  return answer(
      planner, [](const auto& p) -> decltype(p.refits()) { return p.refits(); }, false);
}

/// Whether a planner goes to a target of its own, as MemorylessQuadric.
template <typename Planner, typename = void>
struct takes_target : std::false_type {};
template <typename Planner>
struct takes_target<Planner, std::void_t<decltype(std::declval<Planner&>().target_faces)>> : std::true_type {
};

/// Whether a planner's own target is met, or it has none.
template <typename Planner>
bool is_own_target_met(const Planner& planner, std::size_t n_faces, std::size_t n_vertices) {
  if constexpr (takes_target<Planner>::value)
    if (const TargetCount target{planner.target_faces, planner.target_vertices}; target.any())
      return target.is_met(n_faces, n_vertices);
  return true;
}

/// Whether the result is refitted, as was asked for, or as the planner has it where nothing was.
/// \throw InvalidParameter  the planner keeps a bound, which a refit does not
template <typename Planner>
bool wants_refit(const Planner& planner, std::optional<bool> asked) {
  if constexpr (takes_target<Planner>::value)
    if (asked.value_or(false) && planner.max_distance < HUGE_VAL)
      throw InvalidParameter("a refit does not keep max_distance: leave one of them out");
  return asked.value_or(refits(planner));
}

/// How often a planner runs where a target asks for more than one pass: enough for any threshold to come to rest.
constexpr std::size_t kPassesToTarget = 200;

}  // namespace detail

/// The plan of a planner that is run several times.
struct RepeatedPlan {
  CollapsePlan plan;
  std::size_t passes = 0;  ///< how often it was run, the last time perhaps in vain
};

/// A planner repeated until nothing changes, at most `max_passes` times.
/// \tparam Enough  called with the stages after each pass; true ends the passes.
template <typename Planner, typename Real, typename Enough>
RepeatedPlan plan_passes(const Planner& planner, const SurfaceT<Real>& surface, std::size_t max_passes,
                         Enough enough) {
  RepeatedPlan out;
  StagesT<Real> stages(surface);
  while (out.passes < max_passes) {
    ++out.passes;
    if (stages.add(planner) == 0 || enough(stages)) break;
  }
  out.plan = stages.take();
  return out;
}

}  // namespace whittle
