#include "render/Renderer.hh"

#include <Eigen/Geometry>

#include "render/program.hh"

namespace whittle::render {
namespace {

constexpr char kVertexShader[] = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 model_view;
uniform mat4 projection;
out vec3 eye_position;
out vec3 eye_normal;

void main() {
  vec4 p = model_view * vec4(position, 1.0);
  eye_position = p.xyz;
  eye_normal = mat3(model_view) * normal;  // a rigid motion needs no inverse transpose
  gl_Position = projection * p;
}
)";

// Light adds up linearly; the square root at the end takes it to the screen, the square of the colours back.
constexpr char kFragmentShader[] = R"(#version 330 core
in vec3 eye_position;
in vec3 eye_normal;
uniform vec3 front;
uniform vec3 back;
out vec4 colour;

const vec3 key_direction = vec3(-0.48, 0.68, 0.55);
const vec3 fill_direction = vec3(0.80, 0.05, 0.60);

void main() {
  vec3 toward_eye = normalize(-eye_position);
  vec3 normal = eye_normal / max(length(eye_normal), 1e-6);
  if (!gl_FrontFacing) normal = -normal;
  float sky = mix(0.06, 0.22, 0.5 + 0.5 * normal.y);
  float key = 0.66 * max(dot(normal, key_direction), 0.0);
  float fill = 0.14 * max(dot(normal, fill_direction), 0.0);
  float head = 0.14 * max(dot(normal, toward_eye), 0.0);
  vec3 surface = gl_FrontFacing ? front : back;
  colour = vec4(sqrt(surface * surface * (sky + key + fill + head)), 1.0);
}
)";

}  // namespace

void clear(const Look& look) {
  glClearColor(look.background.x(), look.background.y(), look.background.z(), 1.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

Renderer::Renderer() {
  link_program(program_.name(), kVertexShader, kFragmentShader);
  model_view_ = glGetUniformLocation(program_.name(), "model_view");
  projection_ = glGetUniformLocation(program_.name(), "projection");
  front_ = glGetUniformLocation(program_.name(), "front");
  back_ = glGetUniformLocation(program_.name(), "back");
}

void Renderer::draw(const MeshBuffers& mesh, const Camera& camera, const Look& look) const {
  clear(look);
  draw_part(mesh, camera, look, {});
}

void Renderer::draw_part(const MeshBuffers& mesh, const Camera& camera, const Look& look, Part part) const {
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glUseProgram(program_.name());
  // In double, so that the mesh's origin and the eye cancel before rounding.
  set_uniform(model_view_, camera.view * Eigen::Affine3d(Eigen::Translation3d(mesh.origin())).matrix());
  set_uniform(projection_, camera.projection);
  glUniform3fv(front_, 1, look.front.data());
  glUniform3fv(back_, 1, look.back.data());
  mesh.draw(part);
}

}  // namespace whittle::render
