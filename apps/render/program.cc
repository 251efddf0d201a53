#include "render/program.hh"

#include <string>

namespace whittle::render {
namespace {

void attach(GLuint program, GLenum stage, const char* source) {
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glDeleteShader(shader);  // deleted with the program
}

void link(GLuint program) {
  glLinkProgram(program);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return;
  std::string log(1000, '\0');
  GLsizei length = 0;
  glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  throw RenderError("the OpenGL driver does not take the shaders: " + log.substr(0, log.find('\n')));
}

}  // namespace

void link_program(GLuint program, const char* vertex_shader, const char* fragment_shader) {
  attach(program, GL_VERTEX_SHADER, vertex_shader);
  attach(program, GL_FRAGMENT_SHADER, fragment_shader);
  link(program);
}

void set_uniform(GLint uniform, const Eigen::Matrix4d& matrix) {
  const Eigen::Matrix4f rounded = matrix.cast<float>();
  glUniformMatrix4fv(uniform, 1, GL_FALSE, rounded.data());
}

}  // namespace whittle::render
