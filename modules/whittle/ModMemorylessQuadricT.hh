/// \file
/// mq as an OpenMesh decimater module.
#pragma once

#include <cmath>

#include "whittle/openmesh/ModPlannedT.hh"
#include "whittle/openmesh/describe.hh"
#include "whittle/planners/MemorylessQuadric.hh"
#include "whittle/surface/errors.hh"

namespace whittle {

/// Down to a number of faces with the least change of shape. The parameters are those of MemorylessQuadric: beside those
/// below `set_flip_guard`.
///
/// Set the target here and decimate without one: the planner then knows how far it has to go. A decimater's own target
/// cuts the plan off where it is, which is nearly as good. Whittle's drivers throw NotReady where neither has a target
/// and there is no bound; OpenMesh's own cannot tell, and go on until nothing is legal. Survivors move, but stock
/// binary modules judge a collapse as if they did not.
///
/// Seams, edges at which half-edge texture coordinates (1D, 2D, 3D) differ, move: their vertices merge along them, and
/// both sides take the coordinates of one place of the border.
template <typename MeshT>
class ModMemorylessQuadricT : public ModPlannedT<MeshT, MemorylessQuadric> {
 public:
  DECIMATING_MODULE(ModMemorylessQuadricT, MeshT, MemorylessQuadric);

  explicit ModMemorylessQuadricT(MeshT& mesh) : ModPlannedT<MeshT, MemorylessQuadric>(mesh) {}

  /// So many faces or fewer; the default 0 is no target.
  void set_target_faces(std::size_t faces) {
    this->change([&](MemorylessQuadric& p) { p.target_faces = faces; });
  }
  /// So many vertices or fewer, isolated ones included; the default 0 is no target.
  void set_target_vertices(std::size_t vertices) {
    this->change([&](MemorylessQuadric& p) { p.target_vertices = vertices; });
  }
  /// Edges sharper than so many degrees between the normals of their faces keep their line. 0..180, default
  /// 180: none.
  /// \throw InvalidParameter
  void set_feature_angle(double degrees) {
    this->change([&](MemorylessQuadric& p) { p.feature_angle = degrees; });
  }
  /// No vertex of the mesh lies farther than this from the faces that it is left with. Model units, not
  /// negative; the default HUGE_VAL is no bound. With passes, each bounds what it adds.
  /// \throw InvalidParameter
  void set_max_distance(double distance) {
    this->change([&](MemorylessQuadric& p) { p.max_distance = distance; });
  }
  /// Whether each chart, what seams and the boundary enclose, keeps a face at least. Default: a chart may vanish, and
  /// its neighbours close over it.
  void set_keep_charts(bool keep) {
    this->change([&](MemorylessQuadric& p) { p.keep_charts = keep; });
  }
  /// Lets the mesh's normals, colours and texture coordinates, of vertices and of half-edges, count beside
  /// the shape, where vertices go as well as in what order. Half-edge texture coordinates count where all
  /// corners of a vertex agree. Lengths, not negative; default 0. `initialize()` throws InvalidParameter if
  /// that makes more than 12 values a vertex.
  /// \throw InvalidParameter
  void set_value_weights(const ValueWeights& weights) {
    weights.validate();
    weights_ = weights;
    this->forget();
  }

 protected:
  void describe(const MeshT& mesh, const IndexedMeshT<typename MeshT::Scalar>&,
                SurfaceExtras& extras) override {
    detail::add_values(mesh, weights_, extras);
  }

 private:
  ValueWeights weights_;
};

}  // namespace whittle
