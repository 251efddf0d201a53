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

MeshArrays::MeshArrays(const IndexedMesh& mesh) : normals(vertex_normals(mesh)) {
  if (!mesh.points.empty()) origin = bounding_box(mesh).center();
  positions.reserve(mesh.points.size());
  for (const auto& point : mesh.points) positions.push_back((point - origin).cast<float>());
}

MeshBuffers::MeshBuffers(const MeshArrays& arrays, const std::vector<IndexedMesh::Triangle>& triangles,
                         const std::vector<float>& values)
    : origin_(arrays.origin), triangles_(triangles.size()) {
  glBindVertexArray(vertex_array_.name());
  fill(positions_, 0, arrays.positions);
  fill(normals_, 1, arrays.normals);
  if (!values.empty()) fill(values_, 2, values);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(triangles.size() * sizeof(IndexedMesh::Triangle)), triangles.data(),
               GL_STATIC_DRAW);
  glBindVertexArray(0);
  if (glGetError() != GL_NO_ERROR) throw RenderError("the mesh does not fit into the graphics memory");
}

void MeshBuffers::draw(Part part) const {
  glBindVertexArray(vertex_array_.name());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * part.of(triangles_)), GL_UNSIGNED_INT,
                 buffer_offset(part.first * sizeof(IndexedMesh::Triangle)));
}

}  // namespace whittle::render
