/// \file
/// What Whittle's own decimaters share: OpenMesh's interface, targets, and the execution of a collapse.
#pragma once

#include <OpenMesh/Tools/Decimater/BaseDecimaterT.hh>
#include <cstddef>

#include "whittle/openmesh/HalfedgeCollapse.hh"

namespace whittle {

/// A decimater with the interface of OpenMesh's DecimaterT. A driver decides in `run` which collapse comes
/// next. Unlike DecimaterT's, the targets count living vertices and faces, not deleted ones.
template <typename MeshT>
class DriverT : public OpenMesh::Decimater::BaseDecimaterT<MeshT> {
 public:
  using Base = OpenMesh::Decimater::BaseDecimaterT<MeshT>;
  using Mesh = MeshT;
  using CollapseInfo = typename Base::CollapseInfo;
  using VertexHandle = typename Mesh::VertexHandle;
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;

  explicit DriverT(Mesh& mesh) : Base(mesh), mesh_(mesh), connectivity_(mesh) {}

  /// Executes up to `n_collapses` collapses, all that are allowed for 0.
  /// \return how many were executed.
  std::size_t decimate(std::size_t n_collapses = 0, bool only_selected = false) {
    return start({n_collapses ? n_collapses : kNoLimit, 0, 0}, only_selected);
  }

  /// Down to `n_vertices` living vertices.
  std::size_t decimate_to(std::size_t n_vertices, bool only_selected = false) {
    return start({kNoLimit, n_vertices, 0}, only_selected);
  }

  /// Until the mesh has at most `n_vertices` living vertices or at most `n_faces` living faces.
  std::size_t decimate_to_faces(std::size_t n_vertices = 0, std::size_t n_faces = 0,
                                bool only_selected = false) {
    return start({kNoLimit, n_vertices, n_faces}, only_selected);
  }

 protected:
  /// Executes collapses until `finished()` or until there is none.
  virtual void run(bool only_selected) = 0;

  /// Whether the target is met or the observer has called a halt.
  bool finished() const {
    return halted_ || collapses_ >= target_.collapses || vertices_ <= target_.vertices ||
           faces_ <= target_.faces;
  }

  /// What OpenMesh's decimaters call legal.
  bool is_legal(HalfedgeHandle h) {
    if constexpr (Mesh::is_trimesh())
      return connectivity_.is_legal(h);
    else  // faces may have more corners
      return this->is_collapse_legal(CollapseInfo(mesh_, h));
  }

  /// Executes a legal collapse with all that belongs to it.
  void execute(CollapseInfo& ci) {
    --vertices_;
    faces_ -= (ci.fl.is_valid() ? 1u : 0u) + (ci.fr.is_valid() ? 1u : 0u);
    this->preprocess_collapse(ci);
    if constexpr (Mesh::is_trimesh())
      connectivity_.collapse(ci.v0v1);
    else
      mesh_.collapse(ci.v0v1);
    if (mesh_.has_face_normals())
      for (auto f = mesh_.cvf_iter(ci.v1); f.is_valid(); ++f)
        mesh_.set_normal(*f, mesh_.calc_face_normal(*f));
    this->postprocess_collapse(ci);
    halted_ = !this->notify_observer(++collapses_);
  }

  Mesh& mesh_;
  HalfedgeCollapseT<Mesh> connectivity_;

 private:
  static constexpr std::size_t kNoLimit = ~std::size_t{0};
  struct Target {
    std::size_t collapses, vertices, faces;  ///< at most so many collapses; stop at so many vertices or faces
  };

  std::size_t start(const Target& target, bool only_selected) {
    if (!this->is_initialized()) return 0;
    target_ = target;
    collapses_ = vertices_ = faces_ = 0;
    halted_ = false;
    for (int v = 0; v < static_cast<int>(mesh_.n_vertices()); ++v)
      vertices_ += !mesh_.status(VertexHandle(v)).deleted();
    for (int f = 0; f < static_cast<int>(mesh_.n_faces()); ++f)
      faces_ += !mesh_.status(typename Mesh::FaceHandle(f)).deleted();
    run(only_selected);
    return collapses_;
  }

  Target target_{};
  std::size_t collapses_ = 0, vertices_ = 0, faces_ = 0;
  bool halted_ = false;
};

}  // namespace whittle
