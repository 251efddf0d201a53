#include "window/theme.hh"

#include <cmath>
#include <filesystem>

namespace whittle::viewer {
namespace {

constexpr float kTextHeight = 15;

constexpr const char* kFonts[] = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu/DejaVuSans.ttf",
    "/usr/local/share/fonts/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
    "/usr/share/fonts/truetype/liberation2/LiberationSans-Regular.ttf",
};

void set_colours(ImGuiStyle& style) {
  ImGui::StyleColorsDark(&style);
  const auto set = [&](ImGuiCol which, float r, float g, float b, float a = 1) {
    style.Colors[which] = {r, g, b, a};
  };
  const auto accent = [&](ImGuiCol which, float opacity) {
    style.Colors[which] = {colour::accent.x, colour::accent.y, colour::accent.z, opacity};
  };
  style.Colors[ImGuiCol_Text] = colour::text;
  set(ImGuiCol_TextDisabled, 0.55f, 0.58f, 0.62f);
  set(ImGuiCol_WindowBg, 0.145f, 0.155f, 0.170f);
  set(ImGuiCol_PopupBg, 0.175f, 0.187f, 0.205f, 0.98f);
  set(ImGuiCol_ChildBg, 0.175f, 0.187f, 0.205f);
  set(ImGuiCol_Border, 0.30f, 0.32f, 0.35f, 0.8f);
  set(ImGuiCol_FrameBg, 0.225f, 0.240f, 0.262f);
  set(ImGuiCol_FrameBgHovered, 0.27f, 0.29f, 0.32f);
  set(ImGuiCol_FrameBgActive, 0.30f, 0.33f, 0.37f);
  set(ImGuiCol_TitleBg, 0.175f, 0.187f, 0.205f);
  set(ImGuiCol_TitleBgActive, 0.175f, 0.187f, 0.205f);
  set(ImGuiCol_Button, 0.245f, 0.262f, 0.287f);
  set(ImGuiCol_ButtonHovered, 0.30f, 0.33f, 0.37f);
  accent(ImGuiCol_ButtonActive, 0.70f);
  set(ImGuiCol_Header, 0.245f, 0.262f, 0.287f);
  set(ImGuiCol_HeaderHovered, 0.30f, 0.33f, 0.37f);
  accent(ImGuiCol_HeaderActive, 0.60f);
  accent(ImGuiCol_CheckMark, 1.0f);
  accent(ImGuiCol_SliderGrab, 0.85f);
  accent(ImGuiCol_SliderGrabActive, 1.0f);
  accent(ImGuiCol_PlotHistogram, 0.90f);
  set(ImGuiCol_Separator, 0.26f, 0.28f, 0.30f);
  set(ImGuiCol_ScrollbarBg, 0, 0, 0, 0);
  set(ImGuiCol_ModalWindowDimBg, 0, 0, 0, 0.45f);
  set(ImGuiCol_TableBorderLight, 0.26f, 0.28f, 0.30f, 0.5f);
}

}  // namespace

std::string find_font() {
  for (const char* path : kFonts) {
    std::error_code error;
    if (std::filesystem::exists(path, error)) return path;
  }
  return {};
}

void set_theme(float scale) {
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  static const ImWchar kGlyphs[] = {0x20,   0xff,   0x2010, 0x2027, 0x2190, 0x2193, 0x2212, 0x2212,
                                    0x221a, 0x221a, 0x25b2, 0x25bc, 0x2715, 0x2717, 0};
  const std::string font = find_font();
  const float height = std::round(kTextHeight * scale);
  if (font.empty() || !io.Fonts->AddFontFromFileTTF(font.c_str(), height, nullptr, kGlyphs)) {
    ImFontConfig config;
    config.SizePixels = height;
    io.Fonts->AddFontDefault(&config);
  }
  ImGuiStyle style;
  set_colours(style);
  style.WindowRounding = 0;
  style.ChildRounding = 5;
  style.FrameRounding = 4;
  style.PopupRounding = 5;
  style.GrabRounding = 3;
  style.ScrollbarRounding = 6;
  style.ScrollbarSize = 11;
  style.WindowBorderSize = 0;
  style.ChildBorderSize = 0;
  style.FrameBorderSize = 1;
  style.WindowPadding = {12, 10};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {6, 4};
  style.CellPadding = {4, 2};
  style.GrabMinSize = 12;
  style.ScaleAllSizes(scale);
  ImGui::GetStyle() = style;
}

}  // namespace whittle::viewer
