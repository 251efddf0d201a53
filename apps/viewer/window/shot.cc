/// \file
/// Pictures that the user requests: drawn between the window's frames, written by a worker.
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <exception>
#include <utility>

#include "files/MeshFile.hh"
#include "model/RecipeText.hh"
#include "window/App.hh"

namespace whittle::viewer {

void App::lay_out_picture(View& view, int width, int height) {
  const Orbit framed = framed_;
  const double aspect = framed_aspect_;
  std::swap(view, view_);
  for (int i = 0; i < kLayouts; ++i) lay_out(width, height, false);
  std::swap(view, view_);
  framed_ = framed;
  framed_aspect_ = aspect;
}

void App::begin_shot(const PictureRequest& request, View view) {
  shot_.reset();
  lay_out_picture(view, request.width, request.height);
  const Sight whole = sight(session_, *scene_, view, ui_.area, ui_.scale);
  shot_.emplace(Shot{request, view, whole, render::Framebuffer(whole.width, whole.height, kPictureSamples),
                     Painting(scene_->strokes(session_, whole, Detail::full))});
  ui_.say("Drawing " + request.path);
}

void App::go_on_with_shot() {
  try {
    if (shot_->sight.edition != scene_->edition())
      return begin_shot(PictureRequest(shot_->request), View(shot_->view));
    shot_->canvas.bind();
    shot_->painting.advance(budget_, when_drawn);
    glDisable(GL_SCISSOR_TEST);
    if (shot_->painting.done()) finish_shot();
  } catch (const std::exception& error) {
    shot_.reset();
    session_.errors.push_back(error.what());
  }
}

void App::finish_shot() {
  const auto [path, width, height] = shot_->request;
  const render::Framebuffer framebuffer(width, height);
  lay_out_picture(shot_->view, width, height);
  shot_->canvas.copy_to(framebuffer.name(), 0, 0);
  shot_.reset();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glDisable(GL_SCISSOR_TEST);
  session_.begin_write(path, [path = path, image = framebuffer.read(), caption = picture_caption()] {
    files::write_file(path, render::encode_png(image, caption));
    return std::vector<std::string>();
  });
}

}  // namespace whittle::viewer
