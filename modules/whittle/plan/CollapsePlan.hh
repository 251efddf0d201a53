/// \file
/// What a planner decides, and what every executor carries out.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace whittle {

/// One half-edge collapse: `from` vanishes into `to`.
///
/// A cluster of n vertices is n - 1 collapses in a row, with one survivor and one target. The survivor lies at
/// the target once all of them have been executed. As long as some have not, because an executor stops in the
/// middle or a constraint forbids them, it lies at the centroid of the vertices that have merged; a survivor
/// that the whole cluster leaves in place does not move.
struct Collapse {
  std::uint32_t from, to;
  std::uint32_t faces;     ///< how many vanish with it: two, or one at a boundary
  std::uint32_t rest;      ///< how many more of its cluster follow; 0 in the last
  Eigen::Vector3d target;  ///< of the whole cluster
};

/// How the planning went. A cluster is a set of vertices that become one: three in a fold of a triangle, two in a fold
/// of an edge or in the removal of a vertex. mq counts as refused the edges that stay illegal until its queue is empty,
/// so none where it reaches its target.
struct PlanRecord {
  std::size_t planned = 0;                ///< clusters in the plan
  std::size_t refused_by_flip_guard = 0;  ///< clusters that would have turned a face over
  std::size_t refused_by_link = 0;        ///< clusters that would have broken the manifold (link condition)
  std::size_t refused_by_seam = 0;   ///< mq: edges that would have moved a seam sideways, or lost a chart
  std::size_t refused_by_bound = 0;  ///< mq: edges that would have broken the bound on the distance
  std::size_t fell_back = 0;         ///< clusters planned smaller than wanted because the whole was refused

  PlanRecord& operator+=(const PlanRecord& other) {
    planned += other.planned;
    refused_by_flip_guard += other.refused_by_flip_guard;
    refused_by_link += other.refused_by_link;
    refused_by_seam += other.refused_by_seam;
    refused_by_bound += other.refused_by_bound;
    fell_back += other.fell_back;
    return *this;
  }
};

namespace detail {

/// Where the survivor of a cluster lies that has not merged whole: the centroid, updated vertex by vertex.
/// \param to       where the survivor lies
/// \param from     where the vertex lay that has merged into it
/// \param target   of the whole cluster
/// \param n_merged how many vertices the survivor stands for within the cluster, `from` included; at least 2
template <typename Real>
Eigen::Matrix<Real, 3, 1> place_of_part(const Eigen::Matrix<Real, 3, 1>& to,
                                        const Eigen::Matrix<Real, 3, 1>& from, const Eigen::Vector3d& target,
                                        std::size_t n_merged) {
  if (to == target.cast<Real>()) return to;
  return to + (from - to) / static_cast<Real>(n_merged);
}

}  // namespace detail

/// An ordered list of half-edge collapses. The place in the list is the rank: executors go through it in
/// order, and every prefix of it is a valid, coarser mesh. `from` occurs at most once; a survivor may serve
/// often.
struct CollapsePlan {
  std::vector<Collapse> collapses;
  /// Where each stage that did something begins in `collapses`; at least {0}.
  std::vector<std::size_t> stages;
  PlanRecord record;
};

}  // namespace whittle
