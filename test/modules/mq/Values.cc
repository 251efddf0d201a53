#include "whittle/mq/Values.hh"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "OpenMeshFixture.hh"
#include "measure/Distance.hh"
#include "measure/MeshFacts.hh"
#include "whittle/ModMemorylessQuadricT.hh"
#include "whittle/bulk.hh"
#include "whittle/planners/MemorylessQuadric.hh"

using namespace whittle;
using meshes::IndexedMesh;
using Vector = Eigen::Vector3f;

namespace {

constexpr std::uint32_t kSide = 60;

/// 1 within a circle on the flat grid, 0 outside, with a soft edge.
double spot(const Eigen::Vector3d& p) {
  const double r = std::hypot(p.x() - 0.5 * kSide, p.y() - 0.5 * kSide);
  return std::clamp((0.3 * kSide - r) / 4 + 0.5, 0.0, 1.0);
}

/// How far the spot, known at the vertices of a flat mesh, is from what it is at the points of the grid.
double error_of_spot(const IndexedMesh& coarse) {
  double sum = 0;
  std::size_t count = 0;
  for (const auto& t : coarse.triangles) {
    const Eigen::Vector3d &a = coarse.points[t[0]], &b = coarse.points[t[1]], &c = coarse.points[t[2]];
    const Eigen::Vector3d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    const double area = (b - a).cross(c - a).z();
    for (double x = std::ceil(low.x()); x <= high.x(); ++x)
      for (double y = std::ceil(low.y()); y <= high.y(); ++y) {
        const Eigen::Vector3d p(x, y, 0);
        const double v = (p - a).cross(c - a).z() / area, w = (b - a).cross(p - a).z() / area;
        if (v < 0 || w < 0 || v + w > 1) continue;
        sum += std::abs((1 - v - w) * spot(a) + v * spot(b) + w * spot(c) - spot(p));
        ++count;
      }
  }
  return sum / static_cast<double>(count);
}

BulkOptions spot_options(const IndexedMesh& grid, double weight) {
  BulkOptions options;
  options.extras.n_values = 1;
  for (const auto& p : grid.points) options.extras.values.push_back(static_cast<float>(weight * spot(p)));
  return options;
}

/// What the edge from vertex 0 to vertex 1 adds at one of them.
mq::SymmetricMatrix along(const mq::Values& values, const Vector& e, std::size_t end) {
  const mq::FourVectors edges(mq::Four(e.x()), mq::Four(e.y()), mq::Four(e.z()));
  return mq::one_of(values.along({0, 0, 0, 0}, {1, 1, 1, 1}, edges)[end], 0);
}

MemorylessQuadric down_to(std::size_t faces) {
  MemorylessQuadric planner;
  planner.target_faces = faces;
  return planner;
}

}  // namespace

TEST_CASE("mq takes a face's slope from its values") {
  mq::Values values({1, 3, 6}, 1);
  const Vector p(0, 0, 0), q(2, 0, 0), r(0, 1, 0);  // 1 + x + 5 y, weight: twice the area
  const auto term = values.term(p, q, r, values.at(0), values.at(1), values.at(2));
  CHECK(term.slopes[0].w() == Approx(2));
  CHECK(term.slopes[0].head<3>().isApprox(2 * Vector(1, 5, 0)));
  CHECK(term.form.xx == Approx(2));
  CHECK(term.form.xy == Approx(10));
  CHECK(term.form.yy == Approx(50));
  CHECK(term.form.zz == 0);
}

TEST_CASE("mq takes the slopes of four faces at once as of each, whether regular, thin or without a value") {
  const float none = std::numeric_limits<float>::quiet_NaN();
  struct Corner {
    Vector position;
    float beyond;  // is read, and means nothing
  };
  const std::vector<Corner> corners{
      {{0, 0, 0}, none}, {{2, 0, 0}, none}, {{0.3f, 1, 0.2f}, none}, {{1, 1e-7f, 0}, none}};
  const mq::Values values({1, -2, 3, 0.5f, 6, none, 7, 8}, 2);  // two values a corner
  CHECK(values.known(1) == 3);
  CHECK(values.known(2) == 1);
  const std::array<std::array<std::size_t, 3>, 4> faces{{{0, 1, 3}, {1, 3, 0}, {0, 1, 2}, {3, 1, 2}}};
  mq::Values::FourFaces four;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& [p, q, r] = faces[k];
    four.p[k] = corners[p].position.data();
    four.q[k] = corners[q].position.data();
    four.r[k] = corners[r].position.data();
    four.at_p[k] = values.at(static_cast<std::uint32_t>(p));
    four.at_q[k] = values.at(static_cast<std::uint32_t>(q));
    four.at_r[k] = values.at(static_cast<std::uint32_t>(r));
  }
  const auto check = [&] {
    std::array<mq::Values::Term, 4> terms;
    values.terms(four, terms);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto vec = [](const float* x) { return Vector(x[0], x[1], x[2]); };
      const auto one = values.term(vec(four.p[k]), vec(four.q[k]), vec(four.r[k]), four.at_p[k], four.at_q[k],
                                   four.at_r[k]);
      for (std::size_t i = 0; i < 2; ++i) CHECK(terms[k].slopes[i] == one.slopes[i]);
      CHECK(terms[k].form.xx == one.form.xx);
      CHECK(terms[k].form.xy == one.form.xy);
      CHECK(terms[k].form.yz == one.form.yz);
      CHECK(terms[k].form.zz == one.form.zz);
    }
  };
  check();
  four.r[0] = four.r[1] = corners[2].position.data();
  check();
}

TEST_CASE("mq's values cost nothing along an edge where they are linear, and their slope across it") {
  mq::Values values({1, 3, 6}, 1);
  const Vector p(0, 0, 0), q(2, 0, 0), r(0, 1, 0);
  const auto term = values.term(p, q, r, values.at(0), values.at(1), values.at(2));
  for (std::uint32_t v = 0; v < 3; ++v) values.add(v, term);
  // From p to q by x along the edge the value changes by x, as the slope says.
  const mq::SymmetricMatrix own = term.form + along(values, q - p, 0);
  CHECK((own * Vector(1, 0, 0)).dot(Vector(1, 0, 0)) == Approx(0).margin(1e-6));
  // Across it the value stays while the slope says 5: the weight times 5 squared.
  CHECK((own * Vector(0, 1, 0)).dot(Vector(0, 1, 0)) == Approx(50));
}

TEST_CASE("mq's values have no slope where one is NaN or the face is a sliver") {
  mq::Values values({1, NAN, 6}, 1);
  const Vector p(0, 0, 0), q(2, 0, 0), r(0, 1, 0);
  CHECK(values.term(p, q, r, values.at(0), values.at(1), values.at(2)).slopes[0].w() == 0);
  const mq::Values all({1, 2, 3}, 1);
  CHECK(all.term(p, q, Vector(1, 1e-6f, 0), all.at(0), all.at(1), all.at(2)).slopes[0].w() == 0);
  CHECK(along(values, q - p, 0).trace() == 0);
}

TEST_CASE("mq spends faces where values change if it is told to") {
  const IndexedMesh grid = meshes::flat_grid(kSide);
  const auto blind = bulk(down_to(400), grid), seeing = bulk(down_to(400), grid, spot_options(grid, 10));
  REQUIRE(seeing.mesh.triangles.size() <= 400);
  CHECK(error_of_spot(seeing.mesh) < 0.4 * error_of_spot(blind.mesh));
  const auto a = measure::facts(grid), b = measure::facts(seeing.mesh);
  CHECK(b.area == Approx(a.area).epsilon(1e-3));
  CHECK(b.euler_characteristic == a.euler_characteristic);
}

TEST_CASE("mq's values may have an offset, and constant ones beside them") {
  const IndexedMesh grid = meshes::flat_grid(30);
  BulkOptions options = spot_options(grid, 2), offset = options, doubled = options;
  for (float& value : offset.extras.values) value += 64;
  doubled.extras.n_values = 2;
  doubled.extras.values.clear();
  for (const float value : options.extras.values)
    for (const float v : {value, 7.0f}) doubled.extras.values.push_back(v);
  const auto plain = bulk(down_to(200), grid, options);
  CHECK(bulk(down_to(200), grid, doubled).mesh.triangles == plain.mesh.triangles);
  CHECK(error_of_spot(bulk(down_to(200), grid, offset).mesh) ==
        Approx(error_of_spot(plain.mesh)).epsilon(0.2));
}

TEST_CASE("mq's module takes its values from the mesh, as far as that has them") {
  using Mesh = fixture::Mesh;
  const IndexedMesh grid = meshes::flat_grid(kSide);
  Mesh mesh = fixture::to_openmesh<Mesh>(grid);
  const auto plan = [&](const ValueWeights& weights) {
    OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
    ModMemorylessQuadricT<Mesh>::Handle handle;
    decimater.add(handle);
    decimater.module(handle).set_target_faces(400);
    decimater.module(handle).set_value_weights(weights);
    return decimater.module(handle).plan();
  };
  const auto pairs = [](const CollapsePlan& of) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
    for (const Collapse& collapse : of.collapses) out.emplace_back(collapse.from, collapse.to);
    return out;
  };
  const auto blind = pairs(plan({}));
  CHECK((pairs(plan({10, 10, 10})) == blind));  // it has nothing yet

  mesh.request_vertex_texcoords2D();
  mesh.request_vertex_colors();
  mesh.request_vertex_normals();
  for (const auto v : mesh.vertices()) {
    const double value = spot(grid.points[static_cast<std::size_t>(v.idx())]);
    mesh.set_texcoord2D(v, {static_cast<float>(value), 0});
    const auto grey = static_cast<unsigned char>(std::lround(255 * value));
    mesh.set_color(v, {grey, grey, grey});
    mesh.set_normal(v, {0, 0, 1});
  }
  CHECK((pairs(plan({})) == blind));
  const CollapsePlan seeing = plan({0, 0, 10});
  CHECK((pairs(seeing) != blind));
  SurfaceExtras extras;
  extras.n_values = 2;
  for (const auto v : mesh.vertices()) {
    extras.values.push_back(10 * mesh.texcoord2D(v)[0]);
    extras.values.push_back(0);
  }
  const bool is_same = pairs(seeing) == pairs(down_to(400).plan(SurfaceT<double>(grid, extras)));
  CHECK(is_same);
  CHECK(error_of_spot(execute(plan({0, 10, 0}), grid).mesh) <
        0.4 * error_of_spot(execute(plan({}), grid).mesh));
  CHECK((pairs(plan({10, 0, 0})) == blind));  // all normals are the same
  CHECK_THROWS_AS(plan({0, -1, 0}), InvalidParameter);
}

TEST_CASE("mq refuses values of another size than the mesh") {
  BulkOptions options;
  options.extras.n_values = 1;
  CHECK_THROWS_AS(bulk(down_to(2), meshes::flat_grid(3), options), InvalidParameter);
  options.extras.n_values = 13;
  options.extras.values.assign(13 * 9, 0.0f);
  CHECK_THROWS_AS(bulk(down_to(2), meshes::flat_grid(3), options), InvalidParameter);
}

TEST_CASE("mq knows a value between two vertices where both have it") {
  const float none = std::nanf("");
  const mq::Values values({1, 5, 3, none, none, 7}, 2);
  const auto both = values.between(0, 1, 0.25f), one = values.between(2, 0, 0.5f);
  CHECK(both[0] == 1.5f);
  CHECK(both[2] == 1);
  CHECK(both[3] == 0);
  CHECK(one[2] == 0);
  CHECK(one[1] == 6);
  CHECK(one[3] == 1);
}
