#include "render/ValueBuffer.hh"

namespace whittle::render {

ValueBuffer::ValueBuffer(const std::vector<float>& values) {
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  if (values.size() > static_cast<std::size_t>(most))
    throw RenderError("the graphics device cannot colour so many vertices");
  glBindBuffer(GL_TEXTURE_BUFFER, buffer_.name());
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(float)), values.data(),
               GL_STATIC_DRAW);
  glBindTexture(GL_TEXTURE_BUFFER, texture_.name());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_R32F, buffer_.name());
  glBindTexture(GL_TEXTURE_BUFFER, 0);
}

void ValueBuffer::bind(GLuint unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_BUFFER, texture_.name());
  glActiveTexture(GL_TEXTURE0);
}

}  // namespace whittle::render
