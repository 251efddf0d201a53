#include "render/PaintedMesh.hh"

#include <Eigen/Geometry>

#include "render/MeshBuffers.hh"
#include "render/program.hh"

namespace whittle::render {
namespace {

constexpr char kPaintedVertexShader[] = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 value;
uniform mat4 model_view;
uniform mat4 projection;
out vec3 eye_normal;
out vec3 paint;

void main() {
  eye_normal = mat3(model_view) * normal;
  paint = value;
  gl_Position = projection * (model_view * vec4(position, 1.0));
}
)";

// The mean of a square wave over a pixel's width is the difference of its integral, a triangle wave, at both ends; so
// the checker fades to grey where its squares are smaller than pixels.
constexpr char kPaintedFragmentShader[] = R"(#version 330 core
in vec3 eye_normal;
in vec3 paint;
uniform bool checkered;
out vec4 colour;

vec2 integral(vec2 x) { return abs(2.0 * fract(0.5 * x) - 1.0); }

vec3 checker(vec2 place) {
  vec2 at = 32.0 * place, width = max(fwidth(at), 1e-4);
  vec2 wave = (integral(at + 0.5 * width) - integral(at - 0.5 * width)) / width;
  float light = 0.7 - 0.3 * clamp(wave.x * wave.y, -1.0, 1.0);
  return light * (0.5 + 0.5 * vec3(place.x, place.y, 1.0 - 0.5 * (place.x + place.y)));
}

void main() {
  vec3 surface = checkered ? checker(paint.xy) : paint;
  colour = vec4(surface * (0.55 + 0.45 * abs(normalize(eye_normal).z)), 1.0);
}
)";

/// Fills a buffer and hands it to the shader as the attribute of this number.
void fill_corners(const GlObject<BufferKind>& buffer, GLuint attribute,
                  const std::vector<Eigen::Vector3f>& values) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(Eigen::Vector3f)),
               values.data(), GL_STATIC_DRAW);
  glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
}

}  // namespace

PaintedMesh::PaintedMesh(const IndexedMesh& mesh, const std::vector<std::array<Eigen::Vector3f, 3>>& corners,
                         Paint paint)
    : corners_(3 * mesh.triangles.size()), paint_(paint) {
  const MeshArrays arrays(mesh);
  origin_ = arrays.origin;
  std::vector<Eigen::Vector3f> positions, normals, values;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      positions.push_back(arrays.positions[mesh.triangles[f][k]]);
      normals.push_back(arrays.normals[mesh.triangles[f][k]]);
      values.push_back(corners[f][k]);
    }
  glBindVertexArray(vertex_array_.name());
  fill_corners(positions_, 0, positions);
  fill_corners(normals_, 1, normals);
  fill_corners(values_, 2, values);
  glBindVertexArray(0);
  if (glGetError() != GL_NO_ERROR) throw RenderError("the mesh does not fit into the graphics memory");
}

void PaintedMesh::draw() const {
  glBindVertexArray(vertex_array_.name());
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_));
}

PaintedRenderer::PaintedRenderer() {
  link_program(program_.name(), kPaintedVertexShader, kPaintedFragmentShader);
}

void PaintedRenderer::draw(const PaintedMesh& mesh, const Camera& camera, const Look& look) const {
  const GLuint program = program_.name();
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  clear(look);
  glUseProgram(program);
  set_uniform(glGetUniformLocation(program, "model_view"),
              camera.view * Eigen::Affine3d(Eigen::Translation3d(mesh.origin())).matrix());
  set_uniform(glGetUniformLocation(program, "projection"), camera.projection);
  glUniform1i(glGetUniformLocation(program, "checkered"), mesh.paint() == Paint::checker ? 1 : 0);
  mesh.draw();
}

}  // namespace whittle::render
