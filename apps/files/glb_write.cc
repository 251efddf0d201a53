/// \file
/// glTF 2.0: writing, as GLB, with one level of detail or several.
#include <algorithm>
#include <cmath>

#include "files/Fault.hh"
#include "files/GlbWriter.hh"
#include "files/formats.hh"

namespace whittle::files {
namespace {

double diagonal_of(const IndexedMesh& mesh) {
  if (mesh.points.empty()) return 0;
  IndexedMesh::Point least = mesh.points[0], most = mesh.points[0];
  for (const IndexedMesh::Point& point : mesh.points) {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  return (most - least).norm();
}

/// From which part of the screen on each level is shown: as long as the error of the next one would be
/// larger than a pixel of a screen of 1080 lines. Empty where the errors do not grow from level to level.
std::vector<double> screen_coverage(const std::vector<LevelView>& levels) {
  constexpr double lines = 1080;
  const double diagonal = diagonal_of(*levels[0].mesh);
  std::vector<double> coverage;
  for (std::size_t i = 1; i < levels.size(); ++i) {
    if (!(levels[i].error > levels[i - 1].error) || !(diagonal > 0)) return {};
    const double height = diagonal / (levels[i].error * lines);  // of the screen's height
    coverage.push_back(std::min(1.0, height * height));
  }
  coverage.push_back(0);
  return coverage;
}

tinygltf::Value list_of(const std::vector<double>& numbers) {
  tinygltf::Value::Array list;
  for (const double number : numbers) list.emplace_back(number);
  return tinygltf::Value(std::move(list));
}

/// The first level is in the scene and names the others, which are not.
void connect_levels(tinygltf::Model& model, const std::vector<LevelView>& levels) {
  tinygltf::Value::Array others;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    tinygltf::Value::Object extras;
    extras["error"] = tinygltf::Value(levels[i].error);
    const std::vector<double> coverage = i == 0 ? screen_coverage(levels) : std::vector<double>();
    if (!coverage.empty()) extras["MSFT_screencoverage"] = list_of(coverage);
    model.nodes[i].extras = tinygltf::Value(std::move(extras));
    if (i > 0) others.emplace_back(static_cast<int>(i));
  }
  tinygltf::Value::Object lod;
  lod["ids"] = tinygltf::Value(std::move(others));
  model.nodes[0].extensions["MSFT_lod"] = tinygltf::Value(std::move(lod));
  model.extensionsUsed.emplace_back("MSFT_lod");
}

}  // namespace

std::string glb_bytes(const std::vector<LevelView>& levels, WriteReport& report) {
  if (levels.empty()) throw Fault("not written: there is no level of detail");
  GlbWriter writer(report);
  for (const LevelView& level : levels) {
    if (!std::isfinite(level.error)) throw Fault("not written: an error that is not finite");
    writer.add(*level.mesh, *level.attributes, *level.parts);
  }
  writer.model().scenes[0].nodes = {0};
  if (levels.size() > 1) connect_levels(writer.model(), levels);
  return writer.bytes();
}

}  // namespace whittle::files
