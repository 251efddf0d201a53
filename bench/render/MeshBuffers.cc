#include "render/MeshBuffers.hh"

namespace whittle::render {
namespace {

/// Fills a buffer and hands it to the shader as the attribute of this number.
template <typename Value>
void fill(const GlObject<BufferKind>& buffer, GLuint attribute, const std::vector<Value>& values) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(Value)), values.data(),
               GL_STATIC_DRAW);
  glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(attribute, sizeof(Value) / sizeof(float), GL_FLOAT, GL_FALSE, 0, nullptr);
}

}  // namespace

std::vector<Eigen::Vector3f> vertex_normals(const IndexedMesh& mesh) {
  std::vector<Eigen::Vector3d> sums(mesh.points.size(), Eigen::Vector3d::Zero());
  for (const auto& [a, b, c] : mesh.triangles) {
    // The cross product's length is twice the area, which is the weight.
    const Eigen::Vector3d weighted = (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
    for (const auto corner : {a, b, c}) sums[corner] += weighted;
  }
  std::vector<Eigen::Vector3f> normals;
  normals.reserve(sums.size());
  for (const auto& sum : sums) {
    const double length = sum.norm();
    normals.push_back(length > 0 ? Eigen::Vector3f((sum / length).cast<float>()) : Eigen::Vector3f::UnitZ());
  }
  return normals;
}

Eigen::AlignedBox3d bounding_box(const IndexedMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto& point : mesh.points) box.extend(point);
  return box;
}

MeshBuffers::MeshBuffers(const IndexedMesh& mesh, const std::vector<float>& values)
    : triangles_(mesh.triangles.size()) {
  if (!mesh.points.empty()) origin_ = bounding_box(mesh).center();
  std::vector<Eigen::Vector3f> positions;
  positions.reserve(mesh.points.size());
  for (const auto& point : mesh.points) positions.push_back((point - origin_).cast<float>());

  glBindVertexArray(vertex_array_.name());
  fill(positions_, 0, positions);
  fill(normals_, 1, vertex_normals(mesh));
  if (!values.empty()) fill(values_, 2, values);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(IndexedMesh::Triangle)),
               mesh.triangles.data(), GL_STATIC_DRAW);
  glBindVertexArray(0);
  if (glGetError() != GL_NO_ERROR) throw RenderError("the mesh does not fit into the graphics memory");
}

void MeshBuffers::draw() const {
  glBindVertexArray(vertex_array_.name());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * triangles_), GL_UNSIGNED_INT, nullptr);
}

}  // namespace whittle::render
