#include "whittle/surface/orientation.hh"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>

#include "catch.hh"

#ifdef WHITTLE_HAS_GMP
#include <gmpxx.h>
#endif

using namespace whittle::detail;
using Eigen::Vector2d;
using Eigen::Vector3d;

TEST_CASE("ExactSum: nothing is rounded") {
  ExactSum<16> sum;
  CHECK(sum.sign() == 0);
  sum.add(1e300);
  sum.add(1);
  sum.add(-1e300);
  CHECK(sum.size() == 1);
  CHECK(sum[0] == 1);
  sum.add(1e-300);
  CHECK(sum.size() == 2);
  sum.add(-1);
  CHECK((sum.size() == 1 && sum[0] == 1e-300));
  sum.add(-1e-300);
  CHECK((sum.size() == 0 && sum.sign() == 0));

  // (1 + 2^-30)^2 - 1 - 2^-29 = 2^-60
  const double x = 1 + 0x1p-30;
  sum.add_product(x, x);
  sum.add(-1);
  sum.add(-0x1p-29);
  CHECK((sum.size() == 1 && sum[0] == 0x1p-60));
  const auto a = ExactSum<2>::difference(1, 0x1p-80), b = ExactSum<2>::difference(1, -0x1p-80);
  CHECK(a.size() == 2);
  ExactSum<9> product;
  product.add_product(a, b, -1);  // 2^-160 - 1
  CHECK((product.sign() == -1 && product.size() == 2 && product[0] == 0x1p-160 && product[1] == -1));
}

TEST_CASE("orient3d: by the last bit") {
  const Vector3d a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  CHECK(orient3d(a, b, c, {0.3, 0.3, 1}) == 1);
  CHECK(orient3d(a, c, b, {0.3, 0.3, 1}) == -1);
  CHECK(orient3d(a, b, c, {7, -3, 0}) == 0);
  CHECK(orient3d(a, b, {3, 0, 0}, {5, 6, 7}) == 0);
  CHECK(orient3d(a, a, a, a) == 0);
  // On the plane x + y + z = 3 t, and beside it by one bit of one coordinate.
  const double t = 0.1, next = std::nextafter(t, 1);
  const Vector3d p(3 * t, 0, 0), q(0, 3 * t, 0), r(0, 0, 3 * t);
  const double third = 3 * t / 4;  // exact, as are its multiples
  CHECK(orient3d(p, q, r, {third, third, 2 * third}) == 0);
  CHECK(orient3d(p, q, r, {third, third, std::nextafter(2 * third, 1)}) == 1);
  CHECK(orient3d(p, q, r, {third, std::nextafter(third, 0), 2 * third}) == -1);
  // A difference that is no double.
  CHECK(orient3d({1e20, 0, 0}, {0, 1, 0}, {0, 0, 1}, {t, 0, 0}) ==
        -orient3d({1e20, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 1, 1}));
  CHECK(orient3d({t, t, t}, {1e20, 1e20, 1e20}, {-1e20, 3, 5}, {next, t, t}) != 0);
}

TEST_CASE("orientation: greatest, least and mixed magnitudes") {
  for (const double s : {1.0, 0x1p-1073, 0x1p-1000, 0x1p-400, 0x1p400, 0x1p1000, 0x1p1022}) {
    INFO(s);
    const Vector3d a(0, 0, 0), b(s, 0, 0), c(0, s, 0);
    CHECK(orient3d(a, b, c, {s, s, s}) == 1);
    CHECK(orient3d(a, b, c, {s, s, -s}) == -1);
    CHECK(orient3d(a, b, c, {s, s, 0}) == 0);
    CHECK(orient3d({s, 0, 0}, {0, s, 0}, {0, 0, s}, {-s, s, s}) == 0);
    CHECK(orient2d({0, 0}, {s, 0}, {0, s}) == 1);
    CHECK(orient2d({-s, -s}, {s, s}, {0, 0}) == 0);
    CHECK(orient2d({-s, -s}, {s, s}, {s, std::nextafter(s, 0)}) == -1);
  }
  const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  CHECK(orient3d({-most, -most, -most}, {most, -most, -most}, {-most, most, -most}, {-most, -most, most}) ==
        1);
  CHECK(orient3d({0, 0, 0}, {least, 0, 0}, {0, least, 0}, {0, 0, least}) == 1);
  CHECK(orient3d({0, 0, 0}, {most, 0, 0}, {0, least, 0}, {0, 0, 1}) == 1);
  // Each axis has a scale of its own.
  CHECK(orient3d({1e300, 1e-300, 0}, {2e300, 1e-300, 0}, {1e300, 2e-300, 0}, {1e300, 1e-300, 5e-324}) == 1);
}

#ifdef WHITTLE_HAS_GMP

namespace {

int exact(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  std::array<std::array<mpq_class, 3>, 3> m;
  const std::array<const Vector3d*, 3> rows{&b, &c, &d};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      m[i][k] = mpq_class((*rows[i])[axis]) - mpq_class(a[axis]);
    }
  const mpq_class determinant = m[2][0] * (m[0][1] * m[1][2] - m[0][2] * m[1][1]) +
                                m[2][1] * (m[0][2] * m[1][0] - m[0][0] * m[1][2]) +
                                m[2][2] * (m[0][0] * m[1][1] - m[0][1] * m[1][0]);
  return sgn(determinant);
}

int exact(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  const mpq_class ax(a.x()), ay(a.y());
  const mpq_class determinant =
      (mpq_class(b.x()) - ax) * (mpq_class(c.y()) - ay) - (mpq_class(b.y()) - ay) * (mpq_class(c.x()) - ax);
  return sgn(determinant);
}

/// How many cases had each sign.
using Tally = std::array<std::size_t, 3>;

class NearlyFlat {
 public:
  explicit NearlyFlat(std::uint32_t seed) : random_(seed) {}

  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vector3d vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  bool chance(double share) { return number(0, 1) < share; }

  /// Three points, and a fourth close to their plane: rounded onto it, or beside it by some bits, or exactly on it.
  std::array<Vector3d, 4> points() {
    const double size = std::ldexp(1.0, static_cast<int>(number(-spread, spread)));
    std::array<Vector3d, 4> p;
    const Vector3d offset =
        chance(0.5) ? vector(size * std::ldexp(1.0, static_cast<int>(number(0, 30)))) : Vector3d(0, 0, 0);
    for (std::size_t i = 0; i < 3; ++i) p[i] = rounded(vector(size) + offset);
    if (chance(0.2)) p[2] = rounded(p[0] + number(-1, 2) * (p[1] - p[0]));  // nearly on a line
    p[3] = rounded(p[0] + number(-1, 1) * (p[1] - p[0]) + number(-1, 1) * (p[2] - p[0]));
    if (chance(0.3)) {  // exact: on a lattice
      for (auto& q : p) q = (q / size * 64).array().round() * size;
      p[3] = p[1] + p[2] - p[0];
    }
    if (chance(0.3)) {
      const auto axis = static_cast<Eigen::Index>(number(0, 3));
      const double away = chance(0.5) ? HUGE_VAL : -HUGE_VAL;
      double& x = p[3][axis];
      x = x != 0 ? std::nextafter(x, away) : std::copysign(size * 0x1p-500, away);
    }
    return p;
  }

  double spread = 20;
  bool floats = false;

 private:
  Vector3d rounded(const Vector3d& p) const { return floats ? Vector3d(p.cast<float>().cast<double>()) : p; }

  std::mt19937 random_;
};

}  // namespace

TEST_CASE("orientation is that of rationals on nearly flat points") {
  NearlyFlat source(7);
  const auto [spread, floats, n] = GENERATE(std::tuple(20.0, true, 15000), std::tuple(1.0, false, 15000),
                                            std::tuple(250.0, false, 15000), std::tuple(500.0, false, 5000));
  source.spread = spread;
  source.floats = floats;
  Tally of_space{}, of_plane{};
  std::size_t wrong = 0;
  const auto which = [](int sign) { return sign < 0 ? 0U : sign == 0 ? 1U : 2U; };
  for (int i = 0; i < n; ++i) {
    const auto p = source.points();
    const int sign = exact(p[0], p[1], p[2], p[3]);
    wrong += orient3d(p[0], p[1], p[2], p[3]) != sign;
    ++of_space[which(sign)];
    const Vector2d a = p[0].head<2>(), b = p[1].head<2>();
    Vector2d c = a + source.number(-1, 2) * (b - a);
    if (source.chance(0.2)) c = 2 * b - a;
    const int turn = exact(a, b, c);
    wrong += orient2d(a, b, c) != turn;
    ++of_plane[which(turn)];
  }
  CHECK(wrong == 0);
  for (const std::size_t count :
       {of_space[0], of_space[1], of_space[2], of_plane[0], of_plane[1], of_plane[2]})
    CHECK(count > static_cast<std::size_t>(n) / 50);
}

#endif
