/// \file
/// glTF 2.0: writing, with one level of detail or several.
#include <cmath>

#include "files/Fault.hh"
#include "files/GltfWriter.hh"
#include "files/companions.hh"
#include "files/formats.hh"
#include "files/gltf_extensions.hh"
#include "files/gltf_pack.hh"
#include "files/levels.hh"

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

/// The first level is in the scene and names the others, which are not.
void connect_level_views(nlohmann::json& document, const std::vector<LevelView>& levels) {
  std::vector<double> errors;
  nlohmann::json others = nlohmann::json::array();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    errors.push_back(levels[i].error);
    document["nodes"][i]["extras"]["error"] = levels[i].error;
    if (i > 0) others.push_back(i);
  }
  nlohmann::json& first = document["nodes"][0];
  const std::vector<double> coverage = screen_coverage(diagonal_of(*levels[0].mesh), errors);
  if (!coverage.empty()) first["extras"]["MSFT_screencoverage"] = coverage;
  first["extensions"]["MSFT_lod"]["ids"] = std::move(others);
  use_gltf_extension(document, "MSFT_lod");
}

}  // namespace

GltfOutput gltf_of(const std::vector<LevelView>& levels, WriteReport& report) {
  if (levels.empty()) throw Fault("not written: there is no level of detail");
  GltfWriter writer(report);
  for (const LevelView& level : levels) {
    if (!std::isfinite(level.error)) throw Fault("not written: an error that is not finite");
    writer.add(*level.mesh, *level.attributes, *level.parts);
  }
  if (levels.size() > 1) connect_level_views(writer.output().json(), levels);
  return std::move(writer.output());
}

void encode_gltf(GltfOutput& document, const std::filesystem::path& path, Format format,
                 const WriteOptions& options, bool is_own, Encoded& out) {
  pack_gltf(document, options, is_own, out.report);
  if (format != Format::gltf) {
    out.bytes = document.glb();
    return;
  }
  const std::string name = own_name(out.companions, path, path.stem().string() + ".bin", document.finish());
  std::string data;
  out.bytes = document.gltf(name, data);
  if (!data.empty()) out.companions.push_back({path.parent_path() / name, std::move(data)});
}

}  // namespace whittle::files
