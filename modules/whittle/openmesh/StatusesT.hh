/// \file
/// What OpenMesh needs to mark elements as deleted.
#pragma once

namespace whittle::detail {

/// The status properties that a decimation needs, for as long as this lives.
template <typename Mesh>
class StatusesT {
 public:
  explicit StatusesT(Mesh& mesh) : mesh_(mesh) {
    mesh_.request_vertex_status();
    mesh_.request_edge_status();
    mesh_.request_face_status();
  }
  ~StatusesT() {
    mesh_.release_vertex_status();
    mesh_.release_edge_status();
    mesh_.release_face_status();
  }
  StatusesT(const StatusesT&) = delete;
  StatusesT& operator=(const StatusesT&) = delete;

 private:
  Mesh& mesh_;
};

}  // namespace whittle::detail
