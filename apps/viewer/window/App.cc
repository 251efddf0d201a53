#include "window/App.hh"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
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
constexpr int kAnswer = 3;                // frames after an event

double milliseconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now).count();
}

}  // namespace

double when_drawn() {
  glFinish();
  return milliseconds();
}

App::App(Window& window, Session& session, Settings& settings, View view, double budget)
    : window_(window),
      session_(session),
      settings_(settings),
      view_(std::move(view)),
      budget_(budget),
      ui_(session_, view_, settings_) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui_ImplGlfw_InitForOpenGL(window_.handle(), true);
  ImGui_ImplOpenGL3_Init("#version 330 core");
  ui_.scale = 0;
  follow_scale();
  scene_.emplace();
  session_.set_plan_wanted(view_.plan);
}

App::~App() {
  shot_.reset();
  timing_ = {};
  views_.reset();
  scene_.reset();
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void App::follow_scale() {
  const auto scale = static_cast<float>(window_.content_scale() * settings_.text_scale);
  if (scale == ui_.scale) return;
  ui_.scale = scale;
  set_theme(ui_.scale);
  ImGui_ImplOpenGL3_DestroyFontsTexture();
}

void App::run(std::vector<Command> script) {
  script_.assign(script.begin(), script.end());
  while (!window_.wants_to_close()) {
    const bool busy = !session_.settled();
    const bool waits =
        !script_.empty() && (script_.front().name == "await" || (script_.front().name == "wait" && busy));
    const bool due = (!script_.empty() && !waits) || has_more_to_draw();
    step(due ? 0 : busy || waits || ImGui::GetTime() < ui_.note_until ? kBusy : kIdle);
    follow_script();
  }
}

void App::settle() {
  do {
    step(has_more_to_draw() ? 0 : kBusy);
    if (!session_.errors.empty()) throw ScriptError(session_.errors.front());
  } while (!at_rest());
}

void App::step(double longest_wait) {
  const double start = milliseconds();
  window_.wait(longest_wait);
  const double woken = milliseconds();
  const bool was_woken = woken - start < 0.95e3 * longest_wait;
  if (window_.take_stir() || was_woken) frames_due_ = kAnswer;
  take_input();
  take_news();
  // Progress and notes go on even if nothing happens.
  const bool stale = longest_wait > 0 || (!session_.settled() && woken - last_frame_ > 1e3 * kBusy);
  if (frames_due_ > 0 || stale || pointer_.moving())
    show_frame();
  else
    work_on();
  if (!script_.empty()) busy_.push_back(milliseconds() - woken);
}

bool App::has_more_to_draw() const {
  return frames_due_ > 0 || pointer_.moving() || shot_ || (views_ && !views_->complete()) ||
         (session_.settled() && timing_.wanting(*scene_));
}

bool App::at_rest() const {
  return session_.settled() && !has_more_to_draw();
}

void App::take_input() {
  for (const std::string& path : window_.take_dropped()) session_.open(path);
  for (const std::string& key : window_.take_keys())
    if (!ImGui::GetIO().WantTextInput || key == "Escape") press_key(ui_, key);
}

void App::take_news() {
  const News news = session_.poll();
  if (news.any()) frames_due_ = kAnswer;
  if (!news.written.empty()) {
    std::string said = "Written: " + news.written;
    for (const std::string& line : news.left_out) said += "; " + line;
    ui_.say(said);
  }
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

void App::show_frame() {
  if (frames_due_ > 0) --frames_due_;
  last_frame_ = milliseconds();
  const int width = window_.width(), height = window_.height();
  if (width < 1 || height < 1) return;  // minimised
  follow_scale();
  lay_out(width, height, true);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  if (window_.visible()) draw_views(height);
  glViewport(0, 0, width, height);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  if (!grab_.empty())
    files::write_file(std::exchange(grab_, {}), render::encode_png(render::read_pixels(width, height)));
  window_.swap();
  serve_requests();
}

void App::draw_views(int window_height) {
  const int samples = settings_.smooth_edges ? 4 : 1;
  if (!views_ || views_->samples() != samples) views_.emplace(samples);
  views_->look_at(sight(session_, *scene_, view_, ui_.area, ui_.scale));
  paint_views();
  views_->show(ui_.area, window_height);
}

bool App::paint_views() {
  try {
    return views_->paint(budget_, *scene_, session_, when_drawn);
  } catch (const render::RenderError& error) {
    session_.errors.push_back(error.what());
    return true;
  }
}

void App::work_on() {
  if (views_ && !views_->complete()) {
    if (paint_views()) frames_due_ = 1;
  } else if (shot_) {
    go_on_with_shot();
  } else if (session_.settled() && timing_.wanting(*scene_)) {
    timing_.advance(*scene_, session_, when_drawn);
    if (!timing_.wanting(*scene_)) frames_due_ = 1;  // to say what came out
  }
}

void App::place_panels(float width, float height) {
  const float text = ImGui::GetFontSize();
  const int w = static_cast<int>(width), h = static_cast<int>(height);
  const int bar = static_cast<int>(ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().WindowPadding.y);
  const int left = static_cast<int>(std::min(21.5f * text, 0.32f * width));
  const int right = static_cast<int>(std::min(20.5f * text, 0.30f * width));
  ui_.area = {left, bar, std::max(w - left - right, 1), std::max(h - bar, 1)};
  draw_toolbar(ui_, {0, 0, w, bar});
  draw_recipe_panel(ui_, {0, bar, left, h - bar});
  draw_numbers_panel(ui_, {w - right, bar, right, h - bar});
}

void App::lay_out(int width, int height, bool panels) {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  io.DisplayFramebufferScale = {1, 1};
  if (ImGui::IsMousePosValid(&io.MousePos)) {
    const auto pixels = static_cast<float>(window_.pixels_a_unit());
    io.MousePos = {pixels * io.MousePos.x, pixels * io.MousePos.y};
  }
  if (panels) pointer_.apply();
  ImGui::NewFrame();
  ui_.original_frame_ms = timing_.milliseconds(*scene_, Which::original);
  ui_.result_frame_ms = timing_.milliseconds(*scene_, Which::result);
  ui_.heat_top = heat_top(session_, view_);
  ui_.places.clear();
  ui_.area = {0, 0, width, height};
  try {
    if (panels) place_panels(io.DisplaySize.x, io.DisplaySize.y);
    draw_over_views(ui_);
    if (panels) {
      draw_progress(ui_);
      draw_dialogs(ui_);
      handle_mouse(ui_);
    }
  } catch (const std::exception& error) {
    session_.errors.push_back(error.what());
  }
  keep_framed();
  ImGui::Render();
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
  const render::Framebuffer framebuffer(width, height);
  for (int i = 0; i < kLayouts; ++i) lay_out(width, height, whole_window);
  paint_whole(*scene_, session_, sight(session_, *scene_, view_, ui_.area, ui_.scale), ui_.area, framebuffer);
  framebuffer.bind();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glDisable(GL_SCISSOR_TEST);
  return framebuffer.read();
}

void App::write_picture(const std::string& path, int width, int height, bool whole_window) {
  files::write_file(path, render::encode_png(picture(width, height, whole_window), picture_caption()));
}

std::string App::picture_caption() const {
  return session_.model() ? session_.command("OUT") : "";
}

void App::serve_requests() {
  if (!ui_.clipboard.empty()) window_.set_clipboard(std::exchange(ui_.clipboard, {}));
  const auto request = std::exchange(ui_.picture, std::nullopt);
  if (!request) return;
  try {
    begin_shot(*request, view_);
  } catch (const std::exception& error) {
    session_.errors.push_back(error.what());
  }
}

}  // namespace whittle::viewer
