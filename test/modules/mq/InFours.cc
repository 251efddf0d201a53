#include "whittle/mq/InFours.hh"

#include <array>
#include <cstddef>
#include <vector>

#include "catch.hh"

using whittle::mq::InFours;

TEST_CASE("items are handed over in fours, the last ones filled up") {
  std::vector<int> taken;
  std::vector<std::size_t> sizes;
  const auto take = [&](const std::array<int, 4>& four, std::size_t n) {
    sizes.push_back(n);
    for (std::size_t i = n; i < 4; ++i) CHECK(four[i] == four[0]);
    taken.insert(taken.end(), four.begin(), four.begin() + static_cast<std::ptrdiff_t>(n));
  };
  InFours<int, decltype(take)> fours(take);
  fours.flush();
  CHECK(sizes.empty());
  for (int i = 0; i < 9; ++i) fours.add(i);
  fours.flush();
  fours.flush();
  CHECK(sizes == std::vector<std::size_t>{4, 4, 1});
  CHECK(taken == std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8});
}
