#include "render/LinePainter.hh"

#include <Eigen/Geometry>

#include "render/program.hh"

namespace whittle::render {
namespace {

// Nearer by a little, or the surface below would hide every other pixel.
constexpr char kVertexShader[] = R"(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 model_view;
uniform mat4 projection;
void main() {
  vec4 eye = model_view * vec4(position, 1.0);
  gl_Position = projection * vec4(eye.xyz * 0.9985, 1.0);
}
)";

constexpr char kGeometryHead[] = R"(#version 330 core
uniform vec2 picture;  // in pixels
uniform float width;
)";

constexpr char kLineShader[] = R"(
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;
out vec2 place;
void main() {
  vec4 a = gl_in[0].gl_Position, b = gl_in[1].gl_Position;
  if (a.w <= 0.0 || b.w <= 0.0) return;
  vec2 along = (b.xy / b.w - a.xy / a.w) * picture;
  along = length(along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
  vec2 aside = vec2(-along.y, along.x) * width / picture;
  place = vec2(0.0);
  gl_Position = vec4(a.xy + aside * a.w, a.zw); EmitVertex();
  gl_Position = vec4(a.xy - aside * a.w, a.zw); EmitVertex();
  gl_Position = vec4(b.xy + aside * b.w, b.zw); EmitVertex();
  gl_Position = vec4(b.xy - aside * b.w, b.zw); EmitVertex();
  EndPrimitive();
}
)";

constexpr char kDotShader[] = R"(
layout(points) in;
layout(triangle_strip, max_vertices = 4) out;
out vec2 place;
void main() {
  vec4 centre = gl_in[0].gl_Position;
  for (int i = 0; i < 4; ++i) {
    place = vec2(i % 2 == 0 ? -1.0 : 1.0, i < 2 ? -1.0 : 1.0);
    gl_Position = vec4(centre.xy + place * width / picture * centre.w, centre.zw);
    EmitVertex();
  }
  EndPrimitive();
}
)";

constexpr char kFragmentShader[] = R"(#version 330 core
in vec2 place;
uniform vec4 colour;
out vec4 painted;
void main() {
  if (dot(place, place) > 1.0) discard;
  painted = colour;
}
)";

/// Hands the bound buffer to the bound vertex array, and lets go of that.
void take_positions() {
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindVertexArray(0);
}

void link(GLuint program, const char* geometry) {
  const GLuint shader = glCreateShader(GL_GEOMETRY_SHADER);
  const char* sources[] = {kGeometryHead, geometry};
  glShaderSource(shader, 2, sources, nullptr);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glDeleteShader(shader);
  link_program(program, kVertexShader, kFragmentShader);
}

}  // namespace

PointBuffer::PointBuffer(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& origin)
    : indexed_(false), origin_(origin), size_(points.size()) {
  glBindVertexArray(vertex_array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(points.size() * sizeof(Eigen::Vector3f)),
               points.data(), GL_STATIC_DRAW);
  take_positions();
}

PointBuffer::PointBuffer(const MeshBuffers& mesh, const std::vector<std::array<std::uint32_t, 2>>& ends)
    : indexed_(true), origin_(mesh.origin()), size_(2 * ends.size()) {
  glBindVertexArray(vertex_array_.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer_.name());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(size_ * sizeof(std::uint32_t)), ends.data(),
               GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, mesh.positions());
  take_positions();
}

void PointBuffer::draw(GLenum mode, Part part) const {
  glBindVertexArray(vertex_array_.name());
  const auto count = static_cast<GLsizei>(part.of(size_));
  if (indexed_)
    glDrawElements(mode, count, GL_UNSIGNED_INT, buffer_offset(part.first * sizeof(std::uint32_t)));
  else
    glDrawArrays(mode, static_cast<GLint>(part.first), count);
}

LinePainter::LinePainter() {
  link(lines_.name(), kLineShader);
  link(dots_.name(), kDotShader);
}

void LinePainter::draw_lines(const PointBuffer& ends, const Camera& camera, const Eigen::Vector4f& colour,
                             float width, Part part) const {
  const std::size_t n = part.of(ends.size() / 2);
  draw(ends, camera, colour, width, GL_LINES, {2 * part.first, 2 * n});
}

void LinePainter::draw_dots(const PointBuffer& points, const Camera& camera, const Eigen::Vector4f& colour,
                            float width, Part part) const {
  draw(points, camera, colour, width, GL_POINTS, part);
}

void LinePainter::draw(const PointBuffer& points, const Camera& camera, const Eigen::Vector4f& colour,
                       float width, GLenum mode, Part part) const {
  if (part.of(points.size()) == 0) return;
  GLint viewport[4];
  glGetIntegerv(GL_VIEWPORT, viewport);
  const GLuint program = mode == GL_LINES ? lines_.name() : dots_.name();
  glUseProgram(program);
  set_uniform(glGetUniformLocation(program, "model_view"),
              camera.view * Eigen::Affine3d(Eigen::Translation3d(points.origin())).matrix());
  set_uniform(glGetUniformLocation(program, "projection"), camera.projection);
  glUniform2f(glGetUniformLocation(program, "picture"), static_cast<float>(viewport[2]),
              static_cast<float>(viewport[3]));
  glUniform1f(glGetUniformLocation(program, "width"), width);
  glUniform4fv(glGetUniformLocation(program, "colour"), 1, colour.data());
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // stays opaque
  points.draw(mode, part);
  glDisable(GL_BLEND);
}

}  // namespace whittle::render
