#include "render/HeatPainter.hh"

#include <Eigen/Geometry>

#include "render/Renderer.hh"
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

constexpr char kFragmentShader[] = R"(#version 330 core
in vec3 eye_normal;
in float heat;
out vec4 colour;

const vec3 stops[5] = vec3[5](vec3(0.267, 0.005, 0.329), vec3(0.231, 0.322, 0.545), vec3(0.129, 0.569, 0.549),
                              vec3(0.369, 0.788, 0.384), vec3(0.993, 0.906, 0.144));

void main() {
  float along = 4.0 * clamp(heat, 0.0, 1.0);
  int stop = min(int(along), 3);
  vec3 surface = mix(stops[stop], stops[stop + 1], along - float(stop));
  colour = vec4(surface * (0.55 + 0.45 * abs(normalize(eye_normal).z)), 1.0);
}
)";

}  // namespace

HeatPainter::HeatPainter() {
  link_program(program_.name(), kVertexShader, kFragmentShader);
  model_view_ = glGetUniformLocation(program_.name(), "model_view");
  projection_ = glGetUniformLocation(program_.name(), "projection");
}

void HeatPainter::draw(const MeshBuffers& mesh, const Camera& camera) const {
  const Look look;
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glClearColor(look.background.x(), look.background.y(), look.background.z(), 1.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

  glUseProgram(program_.name());
  set_uniform(model_view_, camera.view * Eigen::Affine3d(Eigen::Translation3d(mesh.origin())).matrix());
  set_uniform(projection_, camera.projection);
  mesh.draw();
}

}  // namespace whittle::render
