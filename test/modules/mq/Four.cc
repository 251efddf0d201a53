#include "whittle/mq/Four.hh"

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <vector>

#include "catch.hh"

using namespace whittle::mq;
using Eigen::Vector3f;

namespace {

/// Three floats with one behind them.
struct Row {
  Vector3f v;
  float rest = 99;
};

Vector3f lane(const FourVectors& v, Eigen::Index i) {
  return {v.x()[i], v.y()[i], v.z()[i]};
}
void check_same(const SymmetricMatrix& a, const SymmetricMatrix& b) {
  CHECK(a.xx == b.xx);
  CHECK(a.xy == b.xy);
  CHECK(a.xz == b.xz);
  CHECK(a.yy == b.yy);
  CHECK(a.yz == b.yz);
  CHECK(a.zz == b.zz);
}

struct Random {
  std::mt19937 bits{7};
  float operator()() { return std::uniform_real_distribution<float>(-1, 1)(bits); }
  Vector3f vector() {
    const float x = (*this)(), y = (*this)();
    return {x, y, (*this)()};
  }
  SymmetricMatrix matrix() {
    return SymmetricMatrix::outer(vector(), 1) + SymmetricMatrix::outer(vector(), 2) +
           SymmetricMatrix::identity(0.1f);
  }
};

}  // namespace

TEST_CASE("four vectors are computed as each by itself, to the bit") {
  Random random;
  std::vector<Row> a(4), b(4);
  for (std::size_t i = 0; i < 4; ++i) a[i].v = random.vector(), b[i].v = random.vector();
  const auto gather = [](const std::vector<Row>& rows) {
    return gathered({rows[3].v.data(), rows[1].v.data(), rows[0].v.data(), rows[2].v.data()});
  };
  const FourVectors p = gather(a), q = gather(b);
  const FourVectors sum = p + q, difference = p - q, cross = p.cross(q), scaled = p.dot(q) * p;
  const std::size_t order[] = {3, 1, 0, 2};
  for (Eigen::Index i = 0; i < 4; ++i) {
    const Vector3f &v = a[order[i]].v, &w = b[order[i]].v;
    CHECK(lane(p, i) == v);
    CHECK(lane(sum, i) == v + w);
    CHECK(lane(difference, i) == v - w);
    CHECK(lane(cross, i) == v.cross(w));
    CHECK(p.dot(q)[i] == v.dot(w));
    CHECK(p.squaredNorm()[i] == v.squaredNorm());
    CHECK(lane(scaled, i) == v.dot(w) * v);
  }
}

TEST_CASE("four symmetric matrices are computed as each by itself, to the bit") {
  Random random;
  std::array<SymmetricMatrix, 4> m;
  std::vector<Row> rows(4);
  for (SymmetricMatrix& matrix : m) matrix = random.matrix();
  for (Row& row : rows) row.v = random.vector();
  const FourMatrices four = gathered({&m[2], &m[0], &m[3], &m[0]});
  const FourVectors b = gathered({rows[0].v.data(), rows[1].v.data(), rows[2].v.data(), rows[3].v.data()});
  FourVectors pivots;
  const FourVectors product = four * b, solution = four.solve(b, pivots);
  const auto back = apart(four);
  const std::size_t order[] = {2, 0, 3, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    const SymmetricMatrix& matrix = m[order[i]];
    const auto k = static_cast<Eigen::Index>(i);
    check_same(back[i], matrix);
    CHECK(lane(product, k) == matrix * rows[i].v);
    Vector3f own;
    CHECK(lane(solution, k) == matrix.solve(rows[i].v, own));
    CHECK(lane(pivots, k) == own);
    CHECK(four.trace()[k] == matrix.trace());
  }
}

TEST_CASE("rows become columns and back") {
  const std::array<std::array<float, 4>, 4> rows{
      {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}, {12, 13, 14, 15}}};
  const auto columns = transposed({rows[0].data(), rows[1].data(), rows[2].data(), rows[3].data()});
  const Eigen::Matrix4f again = transposed(columns[0], columns[1], columns[2], columns[3]);
  for (Eigen::Index i = 0; i < 4; ++i)
    for (Eigen::Index k = 0; k < 4; ++k) {
      CHECK(columns[static_cast<std::size_t>(k)][i] == static_cast<float>(4 * i + k));
      CHECK(again(k, i) == static_cast<float>(4 * i + k));
    }
}

TEST_CASE("reciprocal lengths, and none of a vector without length") {
  const Four lengths = reciprocal_lengths(Four(4, 0, 1e-40f, 2));
  CHECK(lengths[0] == 0.5f);
  CHECK(lengths[1] == 1 / kLeastLength);
  CHECK(lengths[2] == 1 / kLeastLength);
  CHECK(lengths[3] == 1 / std::sqrt(2.0f));
  // What is shorter than floats can square must not weigh more than it is long.
  const Vector3f tiny(1e-25f, 0, 0);
  CHECK(SymmetricMatrix::outer(tiny, lengths[1]).xx <= tiny.x());
}
