#include "recipe/pieces.hh"

#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

#include "files/subset.hh"
#include "whittle/surface/charts.hh"

namespace whittle::recipe {
namespace {

/// The charts of which no stage takes the last face; none where a chart may vanish, or where seams stay as they are.
std::vector<ChartSize> kept_charts(const Task& task) {
  const auto moves = [](const Stage& stage) { return moves_seams(stage.module); };
  const auto keeps = [&](const Stage& stage) {
    return !moves(stage) || !find_module(stage.module.name).find("charts") ||
           stage.module.word("charts") == "keep";
  };
  const auto& stages = task.stages;
  if (task.extras.wedges.empty() || !std::any_of(stages.begin(), stages.end(), moves) ||
      !std::all_of(stages.begin(), stages.end(), keeps))
    return {};
  return chart_sizes(charts(task.mesh.triangles, task.extras.wedges), task.mesh.triangles);
}

}  // namespace

detail::PieceChoice choose_pieces(const Recipe& recipe, Task& task) {
  whittle::PieceRule rule;
  rule.by_error = recipe.pieces.what == PieceRule::What::by_error;
  if (recipe.pieces.what == PieceRule::What::below) rule.below = recipe.pieces.length.in(task.scale);
  detail::PieceChoice choice =
      detail::choose_pieces(task.mesh, task.extras, rule, flags_that_hold(task.stages), kept_charts(task),
                            task.target, recipe.force, std::thread::hardware_concurrency());
  choice.lock(task.extras.flags);
  task.target = choice.target_with_pieces();
  return choice;
}

void remove_pieces(const IndexedMesh& mesh, const detail::PieceChoice& choice, Result& result) {
  if (choice.goes.empty()) return;
  std::vector<bool> face_stays, vertex_stays(result.mesh.points.size(), true);
  face_stays.reserve(result.face_origin.size());
  for (const std::uint32_t origin : result.face_origin)
    face_stays.push_back(!choice.has_gone(mesh.triangles[origin][0]));
  for (std::uint32_t v = 0; v < result.vertex_map.size(); ++v)
    if (choice.has_gone(v)) vertex_stays[result.vertex_map[v]] = false;
  std::vector<std::uint32_t> number;
  number.reserve(vertex_stays.size());
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
  result.pieces_gone = choice.n_gone();
  result.faces_of_pieces_gone = choice.faces_gone();
}

}  // namespace whittle::recipe
