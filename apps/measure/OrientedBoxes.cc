#include "measure/OrientedBoxes.hh"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>

#include "measure/Monitor.hh"

namespace whittle::measure {

namespace {

using Points = std::array<Eigen::Vector3d, 3>;

Points points_of(const Surface& surface, std::uint32_t face) {
  const Corners corners = surface.face(face);
  return {corners.a, corners.b, corners.c};
}

/// The mean of points, and the directions in which they spread, the least first.
struct Spread {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();

  /// \param each  calls what it is given with every point
  template <typename Each>
  Spread(std::size_t n, Each each) {
    each([&](const Eigen::Vector3d& p) { sum += p; });
    mean = sum / static_cast<double>(n);
    each([&](const Eigen::Vector3d& p) { squares += (p - mean) * (p - mean).transpose(); });
  }
  Eigen::Matrix3d directions() const {
    const double scale = squares.trace();
    if (!(scale > 0)) return Eigen::Matrix3d::Identity();
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(squares / scale);
    // The closed form may lose the right angles where two eigenvalues are equal.
    const Eigen::Vector3d z = solver.eigenvectors().col(2).stableNormalized();
    Eigen::Vector3d y = solver.eigenvectors().col(1);
    y -= z * z.dot(y);
    y = y.norm() > 0.1 ? y.normalized() : z.unitOrthogonal();
    Eigen::Matrix3d out;
    out << y.cross(z), y, z;
    return out;
  }
};

}  // namespace

OrientedBoxes::OrientedBoxes(const Surface& surface, std::vector<std::uint32_t> faces,
                             const std::function<bool()>& go_on)
    : surface_(surface), faces_(std::move(faces)) {
  for (const std::uint32_t v : surface.vertices())
    size_ = std::max(size_, surface.point(v).cwiseAbs().maxCoeff());
  build(0, static_cast<std::uint32_t>(faces_.size()), go_on);
}

double OrientedBoxes::mean_overlap(const Surface& surface, const std::vector<std::uint32_t>& faces) {
  Eigen::AlignedBox3d all;
  for (const std::uint32_t v : surface.vertices()) all.extend(surface.point(v));
  // A surface in a plane has no volume: every box is a little thicker than it is.
  const Eigen::Vector3d thickness = Eigen::Vector3d::Constant(1e-3 * all.sizes().maxCoeff());
  double sum = 0;
  for (const std::uint32_t face : faces) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : points_of(surface, face)) box.extend(p);
    sum += (box.sizes() + thickness).cwiseQuotient(all.sizes() + thickness).prod();
  }
  return sum;
}

void OrientedBoxes::build(std::uint32_t begin, std::uint32_t end, const std::function<bool()>& go_on) {
  if (go_on && !go_on()) throw Cancelled();
  const std::size_t at = nodes_.size();
  nodes_.push_back(fitted(begin, end));
  if (end - begin <= kLeaf) return;
  const std::uint32_t middle = begin + (end - begin) / 2;
  split(begin, middle, end);
  build(begin, middle, go_on);
  nodes_[at].second = static_cast<std::uint32_t>(nodes_.size());
  build(middle, end, go_on);
}

/// The box of some faces, a little larger than they are, for the rounding.
auto OrientedBoxes::fitted(std::uint32_t begin, std::uint32_t end) const -> Node {
  const auto each = [&](auto visit) {
    for (std::uint32_t i = begin; i < end; ++i)
      for (const Eigen::Vector3d& p : points_of(surface_, faces_[i])) visit(p);
  };
  Node node;
  node.begin = begin;
  node.end = end;
  node.second = 0;
  const Spread spread(std::size_t{3} * (end - begin), each);
  node.axes = spread.directions().transpose();
  Eigen::AlignedBox3d box;
  each([&](const Eigen::Vector3d& p) { box.extend(Eigen::Vector3d(node.axes * (p - spread.mean))); });
  node.centre = spread.mean + node.axes.transpose() * box.center();
  node.half = (box.sizes() / 2).array() + 1e-12 * size_;
  return node;
}

/// Parts faces by their centroids, across the direction in which these spread most.
void OrientedBoxes::split(std::uint32_t begin, std::uint32_t middle, std::uint32_t end) {
  const auto centroid = [&](std::uint32_t face) -> Eigen::Vector3d {
    const Points p = points_of(surface_, face);
    return (p[0] + p[1] + p[2]) / 3;
  };
  const Spread spread(end - begin, [&](auto visit) {
    for (std::uint32_t i = begin; i < end; ++i) visit(centroid(faces_[i]));
  });
  const Eigen::Vector3d direction = spread.directions().col(2);
  std::vector<std::pair<double, std::uint32_t>> order;
  order.reserve(end - begin);
  for (std::uint32_t i = begin; i < end; ++i)
    order.emplace_back(direction.dot(centroid(faces_[i]) - spread.mean), faces_[i]);
  std::nth_element(order.begin(), order.begin() + (middle - begin), order.end());
  for (std::uint32_t i = begin; i < end; ++i) faces_[i] = order[i - begin].second;
}

}  // namespace whittle::measure
