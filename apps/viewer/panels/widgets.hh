/// \file
/// Small parts that panels are made of.
#pragma once

#include <imgui.h>

#include <string>

#include "model/panes.hh"

namespace whittle::viewer {

/// A panel that fills a place of the window and cannot be moved. Ends with ImGui::End().
void begin_panel(const char* name, const Rect& place);

/// A heading with a thin line below.
void heading(const char* text);

void quiet_text(const std::string& text);

/// A tooltip of the last item.
void tip(const std::string& text);

/// A button that stays pressed. True if it was pressed now.
bool toggle(const char* label, bool on);

bool input_text(const char* label, std::string& text, ImGuiInputTextFlags flags = 0);

/// The end of a slider's drag, or of typing in it.
bool just_released();

}  // namespace whittle::viewer
