#include "recipe/pieces.hh"

#include <algorithm>
#include <thread>
#include <utility>

#include "files/subset.hh"
#include "recipe/Catalogue.hh"
#include "whittle/planners/pieces_by_error.hh"

namespace whittle::recipe {
namespace {

/// The pieces whose boxes are smaller than a length; the largest of all stays.
std::vector<bool> pieces_below(const IndexedMesh& mesh, const Pieces& pieces, double length) {
  const std::vector<double> diagonals = piece_diagonals(mesh, pieces);
  std::vector<bool> goes;
  goes.reserve(diagonals.size());
  for (const double diagonal : diagonals) goes.push_back(diagonal < length);
  const auto largest = std::max_element(diagonals.begin(), diagonals.end());
  if (largest != diagonals.end()) goes[static_cast<std::size_t>(largest - diagonals.begin())] = false;
  return goes;
}

/// A piece with a vertex that the user holds stays.
void keep_held(const Pieces& pieces, const SurfaceExtras& extras, std::vector<bool>& goes) {
  for (std::size_t v = 0; v < extras.flags.size(); ++v)
    if (pieces.of_vertex[v] != Pieces::kNone && (extras.flags[v] & (kLocked | kFeature)) != 0)
      goes[pieces.of_vertex[v]] = false;
  for (std::size_t v = 0; v < extras.tolerance.size(); ++v)
    if (pieces.of_vertex[v] != Pieces::kNone && extras.tolerance[v] == 0) goes[pieces.of_vertex[v]] = false;
}

std::vector<bool> choose(const Recipe& recipe, const Task& task, const Pieces& pieces) {
  switch (recipe.pieces.what) {
    case PieceRule::What::keep:
      return {};
    case PieceRule::What::below: {
      std::vector<bool> goes = pieces_below(task.mesh, pieces, recipe.pieces.length.in(task.scale));
      keep_held(pieces, task.extras, goes);
      return goes;
    }
    case PieceRule::What::by_error:
      return pieces_by_error(task.mesh, pieces, task.extras, task.target,
                             std::thread::hardware_concurrency());
  }
  return {};
}

}  // namespace

PieceChoice choose_pieces(const Recipe& recipe, Task& task) {
  PieceChoice choice;
  choice.attainable.target = task.target;
  if (recipe.pieces.what == PieceRule::What::keep && !task.target.any()) return choice;
  choice.pieces = pieces_of(task.mesh);
  choice.goes = choose(recipe, task, choice.pieces);
  if (std::find(choice.goes.begin(), choice.goes.end(), true) == choice.goes.end()) choice.goes.clear();
  const std::uint8_t holds = flags_that_hold(task.stages);
  choice.attainable =
      attainable(task.mesh, choice.pieces, choice.goes, task.extras.flags, holds, task.target);
  if (recipe.force) {
    choice.attainable.target = task.target;
    choice.attainable.is_higher = false;
  }
  task.target = choice.attainable.target;
  if (choice.goes.empty()) return choice;
  task.extras.flags.resize(task.mesh.points.size(), 0);
  for (std::size_t v = 0; v < task.mesh.points.size(); ++v) {
    const std::uint32_t piece = choice.pieces.of_vertex[v];
    if (piece != Pieces::kNone && choice.goes[piece]) task.extras.flags[v] |= kLocked;
  }
  for (std::size_t p = 0; p < choice.goes.size(); ++p) {
    if (!choice.goes[p]) continue;
    if (task.target.faces > 0) task.target.faces += choice.pieces.faces[p];
    if (task.target.vertices > 0) task.target.vertices += choice.pieces.vertices[p];
  }
  return choice;
}

void remove_pieces(const IndexedMesh& mesh, const PieceChoice& choice, Result& result) {
  if (choice.goes.empty()) return;
  const auto goes = [&](std::uint32_t v) {
    const std::uint32_t piece = choice.pieces.of_vertex[v];
    return piece != Pieces::kNone && choice.goes[piece];
  };
  std::vector<bool> face_stays, vertex_stays(result.mesh.points.size(), true);
  for (const std::uint32_t origin : result.face_origin)
    face_stays.push_back(!goes(mesh.triangles[origin][0]));
  for (std::uint32_t v = 0; v < result.vertex_map.size(); ++v)
    if (goes(v)) vertex_stays[result.vertex_map[v]] = false;
  std::vector<std::uint32_t> number;
  std::uint32_t next = 0;
  for (const bool stays : vertex_stays) number.push_back(stays ? next++ : Result::kNoVertex);
  for (std::uint32_t& v : result.vertex_map) v = number[v];

  files::MeshFile file;
  file.mesh = std::move(result.mesh);
  file.attributes = std::move(result.attributes);
  files::keep_faces(file, face_stays);
  files::keep_vertices(file, vertex_stays);
  result.mesh = std::move(file.mesh);
  result.attributes = std::move(file.attributes);
  std::size_t kept = 0;
  for (std::size_t f = 0; f < face_stays.size(); ++f)
    if (face_stays[f]) result.face_origin[kept++] = result.face_origin[f];
  result.face_origin.resize(kept);
  for (std::size_t p = 0; p < choice.goes.size(); ++p) {
    if (!choice.goes[p]) continue;
    ++result.pieces_gone;
    result.faces_of_pieces_gone += choice.pieces.faces[p];
  }
}

}  // namespace whittle::recipe
