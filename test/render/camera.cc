#include "render/Camera.hh"

#include "catch.hh"

using namespace whittle;

namespace {

/// Where a point comes out, in OpenGL's normalised device coordinates.
Eigen::Vector3d project(const render::Camera& camera, const Eigen::Vector3d& point) {
  return (camera.projection * camera.view * point.homogeneous()).hnormalized();
}

/// How far the corners of a box reach toward the picture's borders; 1 is the border.
Eigen::Vector3d reach(const render::Camera& camera, const Eigen::AlignedBox3d& box) {
  Eigen::Vector3d most = Eigen::Vector3d::Zero();
  for (int i = 0; i < 8; ++i)
    most = most.cwiseMax(
        project(camera, box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i))).cwiseAbs());
  return most;
}

const Eigen::AlignedBox3d kBox(Eigen::Vector3d(-3, 10, 2), Eigen::Vector3d(5, 11, 7));

}  // namespace

TEST_CASE("a framed box fills the picture up to the margin") {
  for (const double aspect : {0.5, 1.0, 3.0}) {
    for (const auto& toward_eye : {Eigen::Vector3d(0, 0, 1), {1, 2, 3}, {-5, 0.1, 0}, {0, -1, -2}}) {
      render::ViewPoint from;
      from.toward_eye = toward_eye;
      from.margin = 0.1;
      const auto most = reach(render::frame(kBox, kBox, aspect, from), kBox);
      INFO("aspect " << aspect << ", toward the eye " << toward_eye.transpose());
      CHECK(most.head<2>().maxCoeff() == Approx(0.8));
      CHECK(most.z() < 1);
    }
  }
}

TEST_CASE("the view is a rigid motion that keeps up up") {
  const auto camera = render::frame(kBox, kBox, 1);
  const Eigen::Matrix3d rotation = camera.view.topLeftCorner<3, 3>();
  CHECK((rotation * rotation.transpose()).isIdentity(1e-12));
  CHECK(rotation.determinant() == Approx(1));
  CHECK(project(camera, kBox.center() + Eigen::Vector3d(0, 0.1, 0)).y() > project(camera, kBox.center()).y());
}

TEST_CASE("a detail view keeps what lies before and behind it within the depth range") {
  const auto part = render::part_of(kBox, {Eigen::Vector3d(0.4, 0.4, 0.4), Eigen::Vector3d(0.6, 0.6, 0.6)});
  const auto camera = render::frame(part, kBox, 1);
  CHECK(reach(camera, part).head<2>().maxCoeff() == Approx(1 - 2 * render::ViewPoint().margin));
  CHECK(project(camera, kBox.center()).cwiseAbs().maxCoeff() < 1);
  const Eigen::Vector3d behind = kBox.center() - Eigen::Vector3d(0, 0, kBox.sizes().z() / 2);
  CHECK(project(camera, behind).z() < 1);
}

TEST_CASE("a part of a box is given in fractions of its sides") {
  const auto part = render::part_of(kBox, {Eigen::Vector3d(0, 0.5, 0.2), Eigen::Vector3d(0.25, 1, 0.4)});
  CHECK(part.min().isApprox(Eigen::Vector3d(-3, 10.5, 3)));
  CHECK(part.max().isApprox(Eigen::Vector3d(-1, 11, 4)));
}
