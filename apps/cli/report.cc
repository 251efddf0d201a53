#include "cli/report.hh"

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

#include "files/gaps.hh"
#include "text/number.hh"
#include "text/printable.hh"

namespace whittle::cli {
namespace {

/// Most of the boundary is where two of its edges run beside each other.
bool is_torn(const files::Gaps& gaps) {
  return gaps.near >= 3 && 2 * gaps.near > gaps.boundary_vertices;
}

}  // namespace

std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json names_of(const std::vector<files::Companion>& companions) {
  Json out = Json::array();
  for (const files::Companion& companion : companions) out.push_back(companion.path.string());
  return out;
}

std::string beside_line(const Json& paths) {
  std::string out;
  for (const Json& path : paths)
    out += (out.empty() ? "  written beside: " : ", ") +
           text::printable(std::filesystem::path(path.get<std::string>()).filename().string());
  return out.empty() ? out : out + "\n";
}

void print_text(const std::string& text) {
  files::write_file("-", text);
}

bool print_summary(const std::string& text) {
  try {
    print_text(text);
    return true;
  } catch (const files::FileError& error) {
    complain(std::string("all is written, but not the summary: ") + error.what());
    return false;
  }
}

void complain(const std::string& message) {
  const bool colour = isatty(STDERR_FILENO) == 1 && std::getenv("NO_COLOR") == nullptr;
  std::cerr << (colour ? "\033[1mwhittle:\033[0m " : "whittle: ") << text::printable(message) << std::endl;
}

void print_notes(const std::string& path, const files::ReadReport& report, bool quiet) {
  for (const std::string& note : quiet ? report.lost_files() : report.notes()) complain(path + ": " + note);
}

void print_notes_on_shape(const std::string& path, const files::ReadReport& report) {
  for (const std::string& note : report.notes_on_shape()) complain(path + ": " + note);
}

std::vector<std::string> missed_because(const recipe::Recipe& recipe, const files::MeshFile& in,
                                        const recipe::Result& result) {
  std::vector<std::string> why = recipe::reasons(recipe, result);
  if (why.empty()) return why;
  const files::ReadReport& read = in.report;
  const auto count = [](std::size_t n) { return std::to_string(n); };
  const files::Gaps gaps = files::find_gaps(in.mesh);
  const std::string weld = "--weld " + (is_torn(gaps) ? text::significant(gaps.length, 2) : "LENGTH");
  if (read.lone_faces > 0)
    why.push_back(count(read.lone_faces) + " faces share no edge with another: " + weld +
                  " joins neighbours");
  else if (is_torn(gaps))
    why.push_back(count(gaps.near) + " of " + count(gaps.boundary_vertices) +
                  " vertices on boundaries have another one beside them: " + weld + " joins them");
  if (read.repair == files::Repair::fix) return why;
  if (read.duplicate_faces > 0)
    why.push_back(count(read.duplicate_faces) +
                  " faces lie on the vertices of others: --repair fix leaves them out");
  else if (read.nonmanifold_edges + read.nonmanifold_vertices > 0)
    why.push_back(count(read.nonmanifold_edges) + " edges and " + count(read.nonmanifold_vertices) +
                  " vertices are not manifold: --repair fix mends them");
  if (read.edges_left_open > 0)
    why.push_back(count(read.edges_left_open) +
                  " edges are open between faces of opposite orientation: --repair fix turns them");
  return why;
}

std::string why_missed(const recipe::Recipe& recipe, const files::MeshFile& in,
                       const recipe::Result& result) {
  const files::ReadReport& read = in.report;
  std::string why;
  for (const std::string& reason : missed_because(recipe, in, result))
    why += (why.empty() ? "" : "; ") + reason;
  // What only wants a weld or a repair to hang together would be torn if its pieces went.
  const bool pieces_would_go = !why.empty() && result.attainable.small > 0 && read.lone_faces == 0 &&
                               read.edges_left_open == 0 &&
                               recipe.pieces.what != recipe::PieceRule::What::by_error;
  std::size_t at_seams = result.attainable.charts + result.held_on_seams;
  for (const recipe::StageResult& stage : result.stages) at_seams += stage.record.refused_by_seam;
  return why + (pieces_would_go ? "; --pieces by-error lets pieces go" : "") +
         (!why.empty() && at_seams > 0 ? "; --drop texture leaves the texture out, with its seams" : "") +
         (result.attainable.is_higher ? "; --force goes on" : "");
}

std::string count_of(const Intersections& intersections) {
  return std::to_string(intersections.pairs.size()) + (intersections.complete ? "" : " or more");
}

std::string figure(double value) {
  return std::isfinite(value) ? text::significant(value, 6) : "too large";
}

}  // namespace whittle::cli
