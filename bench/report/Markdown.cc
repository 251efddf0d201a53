#include <cstdio>
#include <sstream>

#include "experiment/Figures.hh"
#include "report/Report.hh"

namespace whittle::bench {
namespace {

std::string fixed(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

/// "12.3 (11.8 to 12.9)": the median, then the spread.
std::string spread(const Summary& summary, int digits) {
  return fixed(summary.median, digits) + " (" + fixed(summary.min, digits) + " to " +
         fixed(summary.max, digits) + ")";
}

/// What would be read as Markdown inside a table cell is escaped.
std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<') {
      safe += "&lt;";
      continue;
    }
    if (c == '|' || c == '[' || c == ']' || c == '*' || c == '_' || c == '`' || c == '\\') safe += '\\';
    safe += c == '\n' ? ' ' : c;
  }
  return safe;
}

void write_header(std::ostream& out, const Report& report) {
  const Environment& environment = report.environment;
  const Settings& settings = report.settings;
  const auto& original = report.sets.front().facts;
  out << "# Render benchmark: " << escaped(report.model.label) << "\n\n";
  for (const auto& note : report.model.notes) out << "> **Note:** " << escaped(note) << "\n\n";
  out << "- Model: " << escaped(report.model.label);
  if (!report.model.file.empty()) out << ", file " << escaped(report.model.file);
  out << ", " << original.vertices << " vertices, " << original.faces << " triangles\n"
      << "- Image: " << settings.width << "x" << settings.height
      << " pixels, off-screen, one sample a pixel\n"
      << "- Frames: number " << settings.frames.from << " up to " << settings.frames.to << ", that is "
      << settings.frames.timed() << " frames in one span; " << settings.repetitions << " repetitions\n"
      << "- Renderer: " << escaped(environment.gl.renderer) << "; " << escaped(environment.gl.vendor)
      << "; OpenGL " << escaped(environment.gl.version) << "; " << escaped(environment.gl.device) << "\n"
      << "- Processor: " << escaped(environment.cpu_model) << ", " << environment.cpu_threads << " threads\n"
      << "- Build: " << escaped(environment.compiler) << ", " << environment.build_type << ", commit "
      << environment.commit << (environment.commit_dirty ? " with changes" : "") << "\n"
      << "- Date: " << environment.date_utc << "\n\n";
}

void write_table(std::ostream& out, const Report& report) {
  const auto timed = report.settings.frames.timed();
  out << "| Set | Recipe | Vertices | Triangles | Removed, % | Flipped faces | Non-manifold edges | " << timed
      << " frames, ms | GL timer, ms | Frame, ms | Frames per second | Improvement, % | Fall in frame time, "
         "% |\n"
      << "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const auto& set : report.sets) {
    const Figures f = figures(set, report.sets.front(), report.settings.frames);
    const bool original = set.definition.recipe.empty();
    out << "| " << escaped(set.definition.paper_label) << " | "
        << (original ? "" : "`" + set.definition.recipe + "`") << " | " << set.facts.vertices << " | "
        << set.facts.faces << " | " << fixed(f.triangles_removed_percent, 1) << " | " << set.flipped_faces
        << " | " << set.facts.nonmanifold_edges << " | " << spread(f.wall_total_ms, 1) << " | "
        << (f.gl_total_ms ? fixed(f.gl_total_ms->median, 1) : "none") << " | "
        << fixed(f.frame_mean_ms.median, 4) << " | " << fixed(f.frames_per_second.median, 1) << " | "
        << (original ? "" : spread(f.improvement, 1)) << " | "
        << (original ? "" : spread(f.frame_time_fall, 1)) << " |\n";
  }
  out << "\nMedian (smallest to largest) over the repetitions. Improvement is the rise in frames per second, "
         "formed "
         "within each\nrepetition against the original of that repetition.\n\n";
}

void write_pictures(std::ostream& out, const Report& report) {
  out << "## Pictures\n\n";
  for (const auto& set : report.sets) {
    const std::string text = escaped(caption(report.model, set.definition));
    out << "| " << text << " | detail |\n|---|---|\n| ![" << text << "](" << picture_name(set.definition)
        << ") | ![" << text << ", detail](" << ears_picture_name(set.definition) << ") |\n\n";
  }
}

}  // namespace

std::string picture_name(const SetDefinition& set) {
  return set.name + ".png";
}

std::string ears_picture_name(const SetDefinition& set) {
  return set.name + "-ears.png";
}

std::string caption(const Model& model, const SetDefinition& set) {
  return set.paper_label + ", " + model.label;
}

std::string markdown_text(const Report& report) {
  std::ostringstream out;
  write_header(out, report);
  write_table(out, report);
  write_pictures(out, report);
  return out.str();
}

}  // namespace whittle::bench
