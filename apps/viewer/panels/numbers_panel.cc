#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>

#include "model/number.hh"
#include "panels/Ui.hh"
#include "panels/widgets.hh"
#include "window/theme.hh"

namespace whittle::viewer {
namespace {

void cell(const std::string& text, const ImVec4& tone = colour::text) {
  ImGui::TableNextColumn();
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, ImGui::GetContentRegionAvail().x - width));
  ImGui::PushStyleColor(ImGuiCol_Text, tone);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
}

void row(const char* name, const std::string& before, const std::string& after,
         const char* meaning = nullptr) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextColored(colour::quiet, "%s", name);
  if (meaning) tip(meaning);
  cell(before);
  cell(after);
}

std::string percent(double part, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f %%", digits, 100 * part);
  return text;
}

std::string milliseconds(std::optional<double> ms) {
  if (!ms) return "–";
  char text[32];
  std::snprintf(text, sizeof text, *ms < 10 ? "%.2f ms" : "%.1f ms", *ms);
  return text;
}

bool begin_table(const char* name, const char* second, const char* third) {
  if (!ImGui::BeginTable(name, 3, ImGuiTableFlags_SizingStretchProp)) return false;
  ImGui::TableSetupColumn("", 0, 1.35f);
  ImGui::TableSetupColumn(second, 0, 1);
  ImGui::TableSetupColumn(third, 0, 1);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  cell(second, colour::quiet);
  cell(third, colour::quiet);
  return true;
}

void counts(const Ui& ui) {
  const Model* model = ui.session.model();
  const Outcome* outcome = ui.session.outcome();
  const Comparison* comparison = ui.session.comparison();
  if (!begin_table("counts", "original", "result")) return;
  const auto after = [&](std::size_t n) { return outcome ? grouped(n) : std::string("–"); };
  row("vertices", grouped(model->mesh().points.size()), after(outcome ? outcome->mesh().points.size() : 0));
  row("triangles", grouped(model->mesh().triangles.size()),
      after(outcome ? outcome->mesh().triangles.size() : 0));
  const measure::MeshFacts& a = model->inspection.facts;
  const measure::MeshFacts* b = comparison ? &comparison->inspection.facts : nullptr;
  const auto fact = [&](const char* name, std::size_t x, std::size_t measure::MeshFacts::*field) {
    if (x > 0 || (b && b->*field > 0)) row(name, grouped(x), b ? grouped(b->*field) : "…");
  };
  fact("boundary edges", a.boundary_edges, &measure::MeshFacts::boundary_edges);
  fact("non-manifold edges", a.nonmanifold_edges, &measure::MeshFacts::nonmanifold_edges);
  fact("degenerate", a.degenerate_faces, &measure::MeshFacts::degenerate_faces);
  fact("pieces", a.components, &measure::MeshFacts::components);
  row("mean edge", figure(a.mean_edge), b ? figure(b->mean_edge) : "…", "model units");
  row("frame time", milliseconds(ui.original_frame_ms), milliseconds(ui.result_frame_ms),
      "shaded, 512 by 512 pixels, as whittle-bench draws it; the median of five frames");
  ImGui::EndTable();
}

/// What the mesh does not hold as it stood in the file.
void reading(const Ui& ui) {
  for (const std::string& line : ui.session.model()->file.report.notes()) quiet_text(line);
}

void reduction(const Ui& ui) {
  const Outcome* outcome = ui.session.outcome();
  if (!outcome || !ImGui::BeginTable("reduction", 2, ImGuiTableFlags_SizingStretchProp)) return;
  ImGui::TableSetupColumn("", 0, 1.35f);
  ImGui::TableSetupColumn("", 0, 1);
  const auto line = [](const char* name, const std::string& value, const char* meaning,
                       const ImVec4& tone = colour::text) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextColored(colour::quiet, "%s", name);
    tip(meaning);
    cell(value, tone);
  };
  line("triangles removed", percent(outcome->faces_removed(), 1), "of the original's");
  line("decimation time", milliseconds(outcome->milliseconds), "planning and execution");
  const std::size_t flips = outcome->result.flipped_faces;
  line("flipped faces", grouped(flips), "turned by more than 90 degrees against their own original",
       flips > 0 ? colour::warning : colour::text);
  std::size_t refused = 0, passes = 0;
  for (const auto& stage : outcome->result.stages) {
    refused += stage.record.refused_by_flip_guard + stage.record.refused_by_link + stage.refused_by_decimater;
    passes += stage.passes;
  }
  line("passes", grouped(passes), "of all modules together");
  line("merges refused", grouped(refused), "by the flip guard, the link condition or a constraint");
  if (outcome->result.refused_faces > 0)
    line("faces left out", grouped(outcome->result.refused_faces), "not manifold: OpenMesh cannot hold them",
         colour::warning);
  if (outcome->recipe.target.any()) {
    std::string why;
    for (const std::string& reason : recipe::reasons(outcome->recipe, outcome->result))
      why += (why.empty() ? "" : "; ") + reason;
    line("target", why.empty() ? "reached" : "not reached", why.empty() ? "of the recipe" : why.c_str(),
         why.empty() ? colour::text : colour::warning);
  }
  ImGui::EndTable();
}

void distances(const Ui& ui) {
  const Comparison* comparison = ui.session.comparison();
  heading("Distance to the original");
  if (!comparison) {
    quiet_text(ui.session.measuring() ? "measuring …" : "–");
    return;
  }
  if (!comparison->distance) {
    quiet_text("none: one of the meshes has no area");
    return;
  }
  const measure::Distance& d = *comparison->distance;
  if (!begin_table("distances", "model units", "of diagonal")) return;
  const auto distance = [&](const char* name, double x, const char* meaning) {
    row(name, figure(x), d.diagonal > 0 ? percent(x / d.diagonal, 4) : "–", meaning);
  };
  distance("RMS", d.two_sided.rms, "both ways, sampled as by whittle measure");
  distance("mean", d.two_sided.mean, "both ways");
  distance("max", d.two_sided.max, "the larger of both ways (Hausdorff)");
  ImGui::EndTable();
}

/// The upper end of the heat colours.
void heat_scale(Ui& ui) {
  if (!ui.view.heat || !ui.session.comparison()) return;
  bool fixed = ui.view.heat_top.has_value();
  if (ImGui::Checkbox("Colours up to", &fixed))
    ui.view.heat_top = fixed ? std::optional(rounded(ui.heat_top, 3)) : std::nullopt;
  tip("Fixed: results compare with one another. Else the scale ends where 99.5 % of the vertices lie below.");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  ImGui::BeginDisabled(!fixed);
  const double diagonal = ui.session.model()->scale.diagonal;
  double top = ui.heat_top;
  const double least = 1e-6 * diagonal, most = 0.1 * diagonal;
  if (ImGui::SliderScalar("##top", ImGuiDataType_Double, &top, &least, &most, "%.3g model units",
                          ImGuiSliderFlags_Logarithmic))
    ui.view.heat_top = rounded(top, 3);
  ImGui::EndDisabled();
}

}  // namespace

void draw_numbers_panel(Ui& ui, const Rect& place) {
  begin_panel("numbers", place);
  heading("Numbers");
  if (!ui.session.model()) {
    quiet_text("Open a mesh, or drop a file on the window.");
  } else {
    counts(ui);
    reading(ui);
    ImGui::Spacing();
    reduction(ui);
    distances(ui);
    heat_scale(ui);
    draw_histograms(ui);
  }
  ImGui::End();
}

}  // namespace whittle::viewer
