/// \file
/// How a textured result looks.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "egl/EglContext.hh"
#include "render/Camera.hh"
#include "render/Image.hh"
#include "render/PaintedMesh.hh"
#include "speed/textured/TexturedModel.hh"

namespace whittle::speed {

/// Draws with a checker as texture, or in the vertices' colours.
class Pictures {
 public:
  /// \throw egl::EglError, render::RenderError  there is no device that can draw
  explicit Pictures(std::filesystem::path folder);

  const std::string& renderer() const { return context_.facts().renderer; }

  /// Takes this as the original of what comes next, and writes its picture.
  /// \return the picture's place, seen from beside the folder
  std::string begin(const TexturedModel& model);

  /// PSNR of eight views from around, in dB.
  double psnr(const IndexedMesh& mesh, const attributes::Attributes& attributes) const;

  /// Writes a picture of a result, named after the model and `what`.
  /// \return its place, as of begin()
  std::string write(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                    const std::string& what) const;

 private:
  std::vector<render::Image> views(const IndexedMesh& mesh, const attributes::Attributes& attributes) const;

  std::filesystem::path folder_;
  egl::EglContext context_;
  render::PaintedRenderer renderer_;
  std::string name_;
  std::vector<render::Camera> cameras_;
  std::vector<render::Image> original_;
};

}  // namespace whittle::speed
