#include "files/scene_layout.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace whittle::files {
namespace {

using Box = Eigen::AlignedBox3d;

/// How many times as large a transform makes things on average; 1 where it makes nothing of them.
double scale_of(const GltfInstance& instance) {
  if (instance.is_skinned) return 1;
  const double scale = std::cbrt(std::abs(instance.transform.topLeftCorner<3, 3>().determinant()));
  return std::isfinite(scale) && scale > 1e-30 && scale < 1e30 ? scale : 1;
}

std::vector<Box> boxes_of(const Scene& scene, std::size_t meshes) {
  std::vector<Box> boxes(meshes);
  for (std::size_t v = 0; v < scene.file_points.size(); ++v)
    if (scene.file_points[v].allFinite()) boxes[scene.mesh_of[v]].extend(scene.file_points[v]);
  return boxes;
}

double diagonal_of(const std::vector<Box>& boxes, const std::vector<GltfInstance>& instances) {
  Box all;
  for (const GltfInstance& instance : instances) {
    const Box& box = boxes[instance.mesh];
    const Eigen::Matrix4d transform =
        instance.is_skinned ? Eigen::Matrix4d(Eigen::Matrix4d::Identity()) : instance.transform;
    for (int i = 0; i < 8 && !box.isEmpty(); ++i)
      all.extend((transform * box.corner(static_cast<Box::CornerType>(i)).homogeneous()).head<3>());
  }
  const double diagonal = all.isEmpty() ? 0 : all.diagonal().norm();
  return std::isfinite(diagonal) ? diagonal : 0;
}

}  // namespace

void arrange(Scene& scene, const std::vector<GltfInstance>& instances, std::size_t meshes, MeshFile& file) {
  scene.file_points = file.mesh.points;
  scene.placements.resize(meshes);
  std::vector<double> scales(meshes, 0);
  for (const GltfInstance& instance : instances)
    scales[instance.mesh] = std::max(scales[instance.mesh], scale_of(instance));
  const std::vector<Box> boxes = boxes_of(scene, meshes);
  scene.diagonal = diagonal_of(boxes, instances);

  // Cells of a cube, each with room for the largest mesh and as much between them.
  double largest = 0;
  std::size_t shown = 0;
  for (std::size_t i = 0; i < meshes; ++i) {
    if (boxes[i].isEmpty()) continue;
    scene.placements[i].scale = scales[i] > 0 ? scales[i] : 1;
    largest = std::max(largest, scene.placements[i].scale * boxes[i].diagonal().norm());
    ++shown;
  }
  if (scene.diagonal == 0) scene.diagonal = largest;
  const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(shown))));
  const double width = largest > 0 ? 2 * largest : 1;
  std::size_t cell = 0;
  for (std::size_t i = 0; i < meshes && shown > 1; ++i) {
    if (boxes[i].isEmpty()) continue;
    const std::size_t column = cell % side, row = cell / side % side, layer = cell / side / side;
    const Eigen::Vector3d place(static_cast<double>(column), static_cast<double>(row),
                                static_cast<double>(layer));
    scene.placements[i].offset = width * place - scene.placements[i].scale * boxes[i].center();
    ++cell;
  }
  for (std::size_t v = 0; v < file.mesh.points.size(); ++v) {
    const Scene::Placement& placement = scene.placements[scene.mesh_of[v]];
    file.mesh.points[v] = placement.scale * file.mesh.points[v] + placement.offset;
  }
}

std::vector<std::uint32_t> meshes_of_parts(const MeshFile& file) {
  std::vector<std::uint32_t> meshes;
  for (const Scene::Piece& piece : file.scene->pieces)
    meshes.push_back(static_cast<std::uint32_t>(piece.mesh));
  return meshes;
}

std::vector<std::uint32_t> meshes_of_faces(const MeshFile& file) {
  const std::vector<std::uint32_t> of_part = meshes_of_parts(file);
  std::vector<std::uint32_t> meshes;
  for (const std::uint32_t part : file.parts.of_face) meshes.push_back(of_part[part]);
  return meshes;
}

void tell_looks_apart(const Scene& scene, Parts& parts) {
  std::map<std::pair<std::uint32_t, std::string>, std::uint32_t> known;
  std::vector<Material> looks;
  for (std::size_t i = 0; i < parts.list.size(); ++i) {
    const Scene::Piece& piece = scene.pieces[i];
    const auto& primitive = scene.document["meshes"][piece.mesh]["primitives"][piece.primitive];
    const std::string extensions = primitive.contains("extensions") ? primitive["extensions"].dump() : "";
    std::uint32_t& material = parts.list[i].material;
    if (material == Part::none && extensions.empty()) continue;
    const auto [place, is_new] =
        known.emplace(std::pair(material, extensions), static_cast<std::uint32_t>(looks.size()));
    if (is_new) looks.push_back(material == Part::none ? Material() : parts.materials[material]);
    material = place->second;
  }
  parts.materials = std::move(looks);
}

}  // namespace whittle::files
