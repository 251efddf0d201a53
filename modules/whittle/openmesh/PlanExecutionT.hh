/// \file
/// A plan while something carries it out on an OpenMesh mesh.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "whittle/plan/CollapsePlan.hh"

namespace whittle::detail {

/// Which collapses of a plan have been executed, and where their survivors lie. Others may have been forbidden.
template <typename Mesh>
class PlanExecutionT {
 public:
  using VertexHandle = typename Mesh::VertexHandle;
  static constexpr std::uint32_t kNotPlanned = 0xffffffffu;

  PlanExecutionT() = default;
  PlanExecutionT(CollapsePlan plan, std::size_t n_vertices)
      : plan_(std::move(plan)),
        rank_(n_vertices, kNotPlanned),
        executed_(plan_.collapses.size(), false),
        placed_by_(n_vertices, 0) {
    for (std::size_t i = 0; i < plan_.collapses.size(); ++i)
      rank_[plan_.collapses[i].from] = static_cast<std::uint32_t>(i);
  }

  const CollapsePlan& plan() const { return plan_; }
  const Collapse& collapse(std::size_t rank) const { return plan_.collapses[rank]; }
  bool is_executed(std::size_t rank) const { return executed_[rank]; }

  /// The rank of the collapse of one vertex into another; kNotPlanned if there is none.
  std::uint32_t rank(VertexHandle from, VertexHandle to) const {
    const std::uint32_t rank = rank_[static_cast<std::size_t>(from.idx())];
    if (rank == kNotPlanned || plan_.collapses[rank].to != static_cast<std::uint32_t>(to.idx()))
      return kNotPlanned;
    return rank;
  }

  /// Notes that a collapse has been executed, and moves its survivor to where its cluster, or the part of it that has
  /// merged by now, belongs.
  /// \param is_held  a seam holds the survivor, so that it leaves its place by rounding only
  /// \return whether it has moved
  bool settle(Mesh& mesh, std::size_t rank, bool is_held);

  /// For each vertex the one that it has become; itself if it still stands.
  std::vector<int> vertex_map() const {
    std::vector<int> map(rank_.size());
    std::iota(map.begin(), map.end(), 0);
    for (std::size_t i = plan_.collapses.size(); i-- > 0;)
      if (executed_[i]) map[plan_.collapses[i].from] = map[plan_.collapses[i].to];
    return map;
  }

 private:
  using Point = Eigen::Matrix<typename Mesh::Scalar, 3, 1>;

  static VertexHandle vertex(std::uint32_t v) { return VertexHandle(static_cast<int>(v)); }
  static Point point(const Mesh& mesh, VertexHandle v) {
    const auto& p = mesh.point(v);
    return {p[0], p[1], p[2]};
  }
  std::size_t n_merged(std::size_t rank) const;

  CollapsePlan plan_;
  std::vector<std::uint32_t> rank_;  // of the collapse that removes a vertex
  std::vector<bool> executed_;       // for each collapse of the plan
  // For each survivor the last rank of the latest cluster that has moved it.
  std::vector<std::uint32_t> placed_by_;
};

template <typename Mesh>
bool PlanExecutionT<Mesh>::settle(Mesh& mesh, std::size_t rank, bool is_held) {
  executed_[rank] = true;
  const Collapse& collapse = plan_.collapses[rank];
  const VertexHandle v0 = vertex(collapse.from), v1 = vertex(collapse.to);
  // A decimater that does not go by rank may come to a stage's collapse after those of a later stage.
  const auto last = static_cast<std::uint32_t>(rank) + collapse.rest;
  std::uint32_t& placed_by = placed_by_[collapse.to];
  if (last < placed_by) return false;
  placed_by = last;

  const Point before = point(mesh, v1);
  Point after = collapse.target.template cast<typename Mesh::Scalar>();
  if (const std::size_t merged = n_merged(rank); merged > 0)
    after = place_of_part<typename Mesh::Scalar>(before, point(mesh, v0), collapse.target, merged);
  const bool is_locked = mesh.has_vertex_status() && (mesh.status(v1).locked() || mesh.status(v1).feature());
  if (after == before || is_locked) return false;  // it may have been locked since the plan was made
  constexpr auto kRounding = static_cast<typename Mesh::Scalar>(0.1);  // of the edge
  if (is_held && (after - before).norm() > kRounding * (point(mesh, v0) - before).norm()) return false;
  auto p = mesh.point(v1);
  for (std::uint32_t i = 0; i < 3; ++i) p[i] = after[i];
  mesh.set_point(v1, p);
  return true;
}

/// How many vertices of a cluster its survivor stands for, itself included; 0 if that is all of them.
template <typename Mesh>
std::size_t PlanExecutionT<Mesh>::n_merged(std::size_t rank) const {
  const auto& collapses = plan_.collapses;
  const std::size_t last = rank + collapses[rank].rest;
  std::size_t first = rank;
  while (first > 0 && collapses[first - 1].rest > 0) --first;
  std::size_t executed = 0;
  for (std::size_t i = first; i <= last; ++i) executed += executed_[i];
  return executed == last - first + 1 ? 0 : executed + 1;
}

}  // namespace whittle::detail
