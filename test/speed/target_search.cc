#include "speed/TargetSearch.hh"

#include "catch.hh"

using whittle::speed::search_target;

TEST_CASE("the search finds the request of a method that overshoots") {
  CHECK(search_target(500, 1, 10000, [](std::size_t request) { return request / 2; }) == 1000);
  CHECK(search_target(500, 1, 10000, [](std::size_t request) { return request + 77; }) == 423);
}

TEST_CASE("the search finds the nearest of a method's steps") {
  // 0, 100, 200, …: 300 is nearer to 260 than 200.
  const auto steps = [](std::size_t request) { return request / 100 * 100; };
  CHECK(steps(search_target(260, 1, 10000, steps)) == 300);
  CHECK(steps(search_target(240, 1, 10000, steps)) == 200);
}

TEST_CASE("the search ends at a bound where the target is out of reach") {
  const auto same = [](std::size_t request) { return request; };
  CHECK(search_target(5000, 1, 100, same) == 100);
  CHECK(search_target(3, 10, 100, same) == 10);
  CHECK(search_target(7, 4, 4, same) == 4);
}

TEST_CASE("the search tries few requests") {
  int asked = 0;
  search_target(123456, 1, 14000000, [&](std::size_t request) {
    ++asked;
    return request / 3;
  });
  CHECK(asked <= 24);
}
