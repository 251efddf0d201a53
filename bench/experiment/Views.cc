#include "experiment/Views.hh"

#include "render/MeshBuffers.hh"

namespace whittle::bench {
namespace {

/// Of the box's width, height and depth.
const Eigen::AlignedBox3d kEars(Eigen::Vector3d(0.06, 0.74, 0.1), Eigen::Vector3d(0.56, 1.0, 0.75));

}  // namespace

Views views(const IndexedMesh& original, double aspect) {
  const auto box = render::bounding_box(original);
  return {render::frame(box, box, aspect), render::frame(render::part_of(box, kEars), box, aspect)};
}

std::vector<render::Camera> views_around(const IndexedMesh& original, std::size_t count) {
  std::vector<Eigen::Vector3d> directions = {{0, 0, 1}, {0, 0, -1}, {-1, 0, 0},
                                             {1, 0, 0}, {0, 1, 0},  {0, -1, 0}};
  for (int corner = 0; corner < 8; ++corner)
    directions.emplace_back(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
  const auto box = render::bounding_box(original);
  std::vector<render::Camera> cameras;
  for (std::size_t i = 0; i < count; ++i) {
    render::ViewPoint from;
    from.toward_eye = directions[i];
    if (directions[i].x() == 0 && directions[i].z() == 0) from.up = {0, 0, -1};
    cameras.push_back(render::frame(box, box, 1, from));
  }
  return cameras;
}

}  // namespace whittle::bench
