/// \file
/// What every shader program needs.
#pragma once

#include <Eigen/Core>

#include "render/GlObject.hh"

namespace whittle::render {

/// Compiles both shaders into the program.
/// \throw RenderError  the driver does not take them.
void link_program(GLuint program, const char* vertex_shader, const char* fragment_shader);

/// Rounds the matrix to floats.
/// \pre the program is in use.
void set_uniform(GLint uniform, const Eigen::Matrix4d& matrix);

}  // namespace whittle::render
