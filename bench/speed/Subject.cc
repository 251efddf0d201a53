#include "speed/Subject.hh"

#include <utility>

#include "measure/MeshFacts.hh"

namespace whittle::speed {
namespace {

std::uint64_t hash(std::uint64_t state, const void* data, std::size_t bytes) {
  constexpr std::uint64_t kPrime = 0x100000001b3u;
  const auto* byte = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < bytes; ++i) state = (state ^ byte[i]) * kPrime;
  return state;
}

/// Each edge counts once for each of its faces.
double mean_edge_length(const Arrays& arrays) {
  double sum = 0;
  for (const auto& t : arrays.triangles)
    for (int i = 0; i < 3; ++i)
      sum += (arrays.points[t[i]] - arrays.points[t[(i + 1) % 3]]).cast<double>().norm();
  return sum / static_cast<double>(3 * arrays.triangles.size());
}

}  // namespace

std::size_t build(const Arrays& arrays, OpenMeshMesh& mesh) {
  const std::size_t faces = arrays.triangles.size();
  mesh.reserve(arrays.points.size(), faces + faces / 2, faces);
  for (const auto& p : arrays.points) mesh.add_vertex(OpenMeshMesh::Point(p[0], p[1], p[2]));
  std::size_t refused = 0;
  for (const auto& t : arrays.triangles) {
    const auto corner = [&](int i) { return OpenMeshMesh::VertexHandle(static_cast<int>(t[i])); };
    const bool degenerate = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    if (degenerate || !mesh.add_face(corner(0), corner(1), corner(2)).is_valid()) ++refused;
  }
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_halfedge_status();
  mesh.request_face_status();
  return refused;
}

Subject make_subject(std::string name, Arrays arrays) {
  Subject subject;
  subject.name = std::move(name);
  subject.arrays = std::move(arrays);
  subject.refused_faces = build(subject.arrays, subject.mesh);
  subject.mean_edge = mean_edge_length(subject.arrays);
  subject.checksum = checksum(subject.arrays);
  return subject;
}

std::uint64_t checksum(const Arrays& arrays) {
  const std::uint64_t points =
      hash(0xcbf29ce484222325u, arrays.points.data(), arrays.points.size() * sizeof(Arrays::Point));
  return hash(points, arrays.triangles.data(), arrays.triangles.size() * sizeof(Arrays::Triangle));
}

}  // namespace whittle::speed
