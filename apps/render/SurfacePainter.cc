#include "render/SurfacePainter.hh"

#include <Eigen/Geometry>
#include <string>

#include "render/heat_colour.hh"
#include "render/program.hh"

namespace whittle::render {
namespace {

constexpr char kVertexShader[] = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 model_view;
uniform mat4 projection;
uniform bool heated;
uniform samplerBuffer values;
uniform float value_at_top;
out vec3 eye_position;
out vec3 eye_normal;
out float heat;

void main() {
  vec4 p = model_view * vec4(position, 1.0);
  eye_position = p.xyz;
  eye_normal = mat3(model_view) * normal;
  heat = heated ? texelFetch(values, gl_VertexID).r / value_at_top : 0.0;
  gl_Position = projection * p;
}
)";

// Between the two stand the heat colours.
constexpr char kSurfaceHead[] = "#version 330 core\n";
constexpr char kSurfaceShader[] = R"(
in vec3 eye_position;
in vec3 eye_normal;
in float heat;
uniform bool flat_faces;
uniform bool lit;
uniform bool heated;
uniform vec3 front;
uniform vec3 back;
out vec4 colour;

const vec3 key_direction = vec3(-0.48, 0.68, 0.55);
const vec3 fill_direction = vec3(0.80, 0.05, 0.60);
void main() {
  vec3 normal = flat_faces ? cross(dFdx(eye_position), dFdy(eye_position)) : eye_normal;
  normal /= max(length(normal), 1e-30);
  if (flat_faces ? normal.z < 0.0 : !gl_FrontFacing) normal = -normal;
  vec3 surface = !gl_FrontFacing ? back : heated ? heat_colour(heat) : front;
  float light = 1.0;
  if (lit && heated) {  // a little shade shows the form and leaves the colours legible
    light = 0.62 + 0.38 * normal.z;
    colour = vec4(surface * light, 1.0);
    return;
  }
  if (lit) {
    float sky = mix(0.06, 0.22, 0.5 + 0.5 * normal.y);
    float key = 0.66 * max(dot(normal, key_direction), 0.0);
    float fill = 0.14 * max(dot(normal, fill_direction), 0.0);
    float head = 0.14 * max(dot(normal, normalize(-eye_position)), 0.0);
    light = sky + key + fill + head;
  }
  colour = vec4(sqrt(surface * surface * light), 1.0);
}
)";

constexpr char kWireShader[] = R"(#version 330 core
uniform vec4 front_wire;
uniform vec4 back_wire;
out vec4 colour;
void main() { colour = gl_FrontFacing ? front_wire : back_wire; }
)";

void set(GLuint program, const char* uniform, int value) {
  glUniform1i(glGetUniformLocation(program, uniform), value);
}

/// Puts the program to use for a mesh seen by a camera.
void use(GLuint program, const MeshBuffers& mesh, const Camera& camera) {
  glUseProgram(program);
  set_uniform(glGetUniformLocation(program, "model_view"),
              camera.view * Eigen::Affine3d(Eigen::Translation3d(mesh.origin())).matrix());
  set_uniform(glGetUniformLocation(program, "projection"), camera.projection);
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
}

}  // namespace

SurfacePainter::SurfacePainter() {
  const std::string surface = kSurfaceHead + heat_colour_shader() + kSurfaceShader;
  link_program(surface_.name(), kVertexShader, surface.c_str());
  link_program(wires_.name(), kVertexShader, kWireShader);
}

void SurfacePainter::draw(const MeshBuffers& mesh, const Camera& camera, const SurfaceStyle& style,
                          const Look& look, Part part) const {
  const GLuint program = surface_.name();
  use(program, mesh, camera);
  set(program, "flat_faces", style.flat);
  set(program, "lit", style.lit);
  set(program, "heated", style.values != nullptr);
  set(program, "values", 0);
  glUniform1f(glGetUniformLocation(program, "value_at_top"), style.value_at_top);
  glUniform3fv(glGetUniformLocation(program, "front"), 1, look.front.data());
  glUniform3fv(glGetUniformLocation(program, "back"), 1, look.back.data());
  if (style.values) style.values->bind(0);
  mesh.draw(part);
}

void SurfacePainter::draw_wires(const MeshBuffers& mesh, const Camera& camera, const Eigen::Vector4f& front,
                                const Eigen::Vector4f& back, Part part) const {
  const GLuint program = wires_.name();
  use(program, mesh, camera);
  set(program, "heated", 0);
  glUniform4fv(glGetUniformLocation(program, "front_wire"), 1, front.data());
  glUniform4fv(glGetUniformLocation(program, "back_wire"), 1, back.data());
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // stays opaque
  glDepthFunc(GL_LEQUAL);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  mesh.draw(part);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
}

}  // namespace whittle::render
