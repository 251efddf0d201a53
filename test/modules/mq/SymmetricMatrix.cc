#include "whittle/mq/SymmetricMatrix.hh"

#include "catch.hh"

using whittle::mq::SymmetricMatrix;

TEST_CASE("a symmetric matrix solves what it multiplies") {
  const Eigen::Vector3f a(1, 2, -1), b(0, 1, 3), u(0.5f, -2, 4);
  const SymmetricMatrix m =
      SymmetricMatrix::outer(a, 2) + SymmetricMatrix::outer(b, 0.5f) + SymmetricMatrix::identity(1);
  Eigen::Vector3f pivots;
  CHECK((m.solve(m * u, pivots) - u).norm() < 1e-5f);
  CHECK(pivots.minCoeff() > 0);
  CHECK(m.trace() == Approx(2 * 6 + 0.5 * 10 + 3));
  SymmetricMatrix::outer(a, -1).solve(u, pivots);
  CHECK_FALSE(pivots.minCoeff() > 0);
}
