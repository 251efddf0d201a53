/// \file
/// How the panels look.
#pragma once

#include <imgui.h>

#include <string>

namespace whittle::viewer {

/// The colours that panels name themselves.
namespace colour {
inline const ImVec4 accent{0.36f, 0.62f, 0.86f, 1};
inline const ImVec4 quiet{0.62f, 0.65f, 0.69f, 1};
inline const ImVec4 text{0.89f, 0.90f, 0.92f, 1};
inline const ImVec4 warning{0.95f, 0.72f, 0.36f, 1};
inline const ImVec4 original{0.70f, 0.73f, 0.77f, 1};  ///< of the original in histograms
}  // namespace colour

/// A readable font of the system, in the order of preference; empty if none is there.
std::string find_font();

/// Sets fonts, colours and sizes for a screen `scale` times as fine as an ordinary one.
/// \pre ImGui has a context and no frame is begun.
void set_theme(float scale);

}  // namespace whittle::viewer
