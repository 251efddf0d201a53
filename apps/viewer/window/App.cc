#include "window/App.hh"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <filesystem>
#include <utility>

#include "files/MeshFile.hh"
#include "model/RecipeText.hh"
#include "render/Framebuffer.hh"
#include "window/theme.hh"

namespace whittle::viewer {
namespace {

constexpr double kIdle = 5, kBusy = 0.1;  // seconds

}  // namespace

App::App(Window& window, Session& session, Settings& settings, View view)
    : window_(window),
      session_(session),
      settings_(settings),
      view_(std::move(view)),
      ui_{session_, view_, settings_, 1,  {}, 0, Dialog::none, {}, false, 1920,
          1080,     {},    0,         {}, {}, 0, false,        {}, {},    false} {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui_ImplGlfw_InitForOpenGL(window_.handle(), true);
  ImGui_ImplOpenGL3_Init("#version 330 core");
  set_scale();
  scene_.emplace();
  session_.set_plan_wanted(view_.plan);
}

App::~App() {
  scene_.reset();
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void App::set_scale() {
  ui_.scale = static_cast<float>(window_.content_scale() * settings_.text_scale);
  set_theme(ui_.scale);
  ImGui_ImplOpenGL3_DestroyFontsTexture();
}

void App::run(std::vector<Command> script) {
  script_.assign(script.begin(), script.end());
  while (!window_.wants_to_close()) {
    const bool busy = !session_.settled();
    const bool script_waits = !script_.empty() && script_.front().name == "wait" && busy;
    const bool due = (!script_.empty() && !script_waits) || frames_due_ > 0 || more_to_time_;
    step(due ? 0 : busy || ImGui::GetTime() < ui_.note_until ? kBusy : kIdle);
    follow_script();
  }
}

void App::settle() {
  do {
    step(session_.settled() ? 0 : kBusy);
    if (!session_.errors.empty()) throw ScriptError(session_.errors.front());
  } while (!at_rest());
}

void App::step(double longest_wait) {
  const auto start = std::chrono::steady_clock::now();
  window_.wait(longest_wait);
  const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - start;
  if (longest_wait > 0 && waited.count() < 0.95 * longest_wait)
    frames_due_ = 2;
  else if (frames_due_ > 0)
    --frames_due_;
  take_input();
  take_news();
  const int width = window_.width(), height = window_.height();
  if (width < 1 || height < 1) return;  // minimised
  more_to_time_ = frames_due_ == 0 && session_.settled() && scene_->time_frames(session_);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  draw(width, height, 1, true);
  window_.swap();
  serve_requests();
}

bool App::at_rest() const {
  return session_.settled() && frames_due_ == 0 && !more_to_time_;
}

void App::take_input() {
  for (const std::string& path : window_.take_dropped()) session_.open(path);
  for (const std::string& key : window_.take_keys())
    if (!ImGui::GetIO().WantTextInput || key == "Escape") press_key(ui_, key);
}

void App::take_news() {
  const News news = session_.poll();
  if (news.any()) frames_due_ = 2;
  try {
    scene_->update(session_, news);
  } catch (const render::RenderError& error) {
    session_.errors.push_back(error.what());
  }
  if (!news.model) return;
  settings_.remember(session_.model()->path);
  window_.set_title(std::filesystem::path(session_.model()->path).filename().string() + " – Whittle");
  ui_.frame_wanted = true;
}

void App::lay_out(float width, float height, bool panels) {
  if (!panels) {
    ui_.area = {0, 0, static_cast<int>(width), static_cast<int>(height)};
    return draw_over_views(ui_);
  }
  const float text = ImGui::GetFontSize();
  const int w = static_cast<int>(width), h = static_cast<int>(height);
  const int bar = static_cast<int>(ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().WindowPadding.y);
  const int left = static_cast<int>(std::min(21.5f * text, 0.32f * width));
  const int right = static_cast<int>(std::min(20.5f * text, 0.30f * width));
  ui_.area = {left, bar, std::max(w - left - right, 1), std::max(h - bar, 1)};
  draw_toolbar(ui_, {0, 0, w, bar});
  draw_recipe_panel(ui_, {0, bar, left, h - bar});
  draw_numbers_panel(ui_, {w - right, bar, right, h - bar});
  draw_over_views(ui_);
  draw_dialogs(ui_);
}

void App::draw(int width, int height, double pixels_a_unit, bool panels) {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width / pixels_a_unit), static_cast<float>(height / pixels_a_unit)};
  io.DisplayFramebufferScale = {static_cast<float>(pixels_a_unit), static_cast<float>(pixels_a_unit)};
  if (panels) pointer_.apply();
  ImGui::NewFrame();
  ui_.original_frame_ms = scene_->frame_milliseconds(Which::original);
  ui_.result_frame_ms = scene_->frame_milliseconds(Which::result);
  ui_.heat_top = Scene::heat_top(session_, view_);
  try {
    lay_out(io.DisplaySize.x, io.DisplaySize.y, panels);
    if (panels) handle_mouse(ui_);
  } catch (const std::exception& error) {
    session_.errors.push_back(error.what());
  }
  keep_framed();
  ImGui::Render();

  const auto pixels = [&](int x) { return static_cast<int>(std::lround(x * pixels_a_unit)); };
  const Rect area{pixels(ui_.area.x), pixels(ui_.area.y), pixels(ui_.area.width), pixels(ui_.area.height)};
  scene_->draw(session_, view_, area, height, ui_.scale * static_cast<float>(pixels_a_unit));
  glViewport(0, 0, width, height);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void App::keep_framed() {
  if (!session_.model()) return;
  const double aspect = panes(view_, ui_.area, session_.outcome() != nullptr).front().picture.aspect();
  const bool reshaped = view_.orbit == framed_ && aspect != framed_aspect_;
  if (!ui_.frame_wanted && !reshaped) return;
  view_.orbit.frame(session_.model()->box(), aspect);
  framed_ = view_.orbit;
  framed_aspect_ = aspect;
  ui_.frame_wanted = false;
}

render::Image App::picture(int width, int height, bool whole_window) {
  const render::Framebuffer framebuffer(width, height, 4);
  // Panels find their sizes over some frames.
  for (int i = 0; i < 3; ++i) {
    framebuffer.bind();
    draw(width, height, 1, whole_window);
  }
  glDisable(GL_SCISSOR_TEST);
  return framebuffer.read();
}

void App::write_picture(const std::string& path, int width, int height, bool whole_window) {
  const std::string caption =
      session_.model() ? command_text(session_.recipe(), session_.model()->path, "OUT") : "";
  files::write_file(path, render::encode_png(picture(width, height, whole_window), caption));
}

void App::serve_requests() {
  if (!ui_.clipboard.empty()) window_.set_clipboard(std::exchange(ui_.clipboard, {}));
  if (std::exchange(ui_.text_scale_changed, false)) set_scale();
  const auto request = std::exchange(ui_.picture, std::nullopt);
  if (!request) return;
  try {
    write_picture(request->path, request->width, request->height, request->whole_window);
    ui_.say("Written: " + request->path);
  } catch (const std::exception& error) {
    session_.errors.push_back(error.what());
  }
}

}  // namespace whittle::viewer
