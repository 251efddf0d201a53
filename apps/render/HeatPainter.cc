#include "render/HeatPainter.hh"

#include <Eigen/Geometry>

#include <string>

#include "render/Renderer.hh"
#include "render/heat_colour.hh"
#include "render/program.hh"

namespace whittle::render {
namespace {

constexpr char kVertexShader[] = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float value;
uniform mat4 model_view;
uniform mat4 projection;
out vec3 eye_normal;
out float heat;

void main() {
  eye_normal = mat3(model_view) * normal;
  heat = value;
  gl_Position = projection * (model_view * vec4(position, 1.0));
}
)";

// Between the two stand the heat colours.
constexpr char kFragmentHead[] = "#version 330 core\n";
constexpr char kFragmentShader[] = R"(
in vec3 eye_normal;
in float heat;
out vec4 colour;

void main() {
  colour = vec4(heat_colour(heat) * (0.55 + 0.45 * abs(normalize(eye_normal).z)), 1.0);
}
)";

}  // namespace

HeatPainter::HeatPainter() {
  const std::string fragment = kFragmentHead + heat_colour_shader() + kFragmentShader;
  link_program(program_.name(), kVertexShader, fragment.c_str());
  model_view_ = glGetUniformLocation(program_.name(), "model_view");
  projection_ = glGetUniformLocation(program_.name(), "projection");
}

void HeatPainter::draw(const MeshBuffers& mesh, const Camera& camera) const {
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  clear(Look());

  glUseProgram(program_.name());
  set_uniform(model_view_, camera.view * Eigen::Affine3d(Eigen::Translation3d(mesh.origin())).matrix());
  set_uniform(projection_, camera.projection);
  mesh.draw();
}

}  // namespace whittle::render
