/// \file
/// A plan as lines and points: what merges, and where to.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "whittle/plan/CollapsePlan.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::viewer {

/// One merge of the plan: a vertex of the input, and the place where it ends.
struct Merge {
  Eigen::Vector3d from, to;
  bool vanishes = true;  ///< false: the survivor itself, which moves
};

/// What a plan does to the vertices of its mesh, all stages and passes together.
struct PlanPicture {
  std::vector<Merge> merges;             ///< of the vertices that vanish or move
  std::vector<Eigen::Vector3d> targets;  ///< where two or more become one, each once
  std::size_t vertices_gone = 0, faces_gone = 0;
  PlanRecord record;

  /// The same for the graphics memory: the ends of the merges two by two, and the targets, seen from
  /// `origin`.
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3f> line_ends, dots;
};

PlanPicture picture(const IndexedMesh& mesh, const CollapsePlan& plan);

}  // namespace whittle::viewer
