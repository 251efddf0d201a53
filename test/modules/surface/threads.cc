#include "whittle/surface/threads.hh"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include "catch.hh"

using whittle::detail::Crew;

TEST_CASE("a crew does every item of every round once") {
  for (const std::size_t n_threads : {1u, 2u, 4u}) {
    Crew crew(n_threads);
    CHECK(crew.size() <= n_threads);
    for (std::size_t n = 0; n < 60; ++n) {
      std::vector<std::atomic<int>> done(n);
      crew.each(n, [&](std::size_t i) { ++done[i]; });
      for (const auto& times : done) REQUIRE(times == 1);
    }
  }
}

TEST_CASE("a crew covers a range once, whatever the size of its pieces") {
  Crew crew(3);
  for (const std::size_t at_once : {1u, 7u, 50u, 100u}) {
    for (const std::size_t n : {0u, 1u, 7u, 49u, 50u, 51u}) {
      std::vector<std::atomic<int>> done(n);
      std::atomic<bool> fits{true};
      crew.each_range(n, at_once, [&](std::size_t begin, std::size_t end) {
        if (begin >= end || end - begin > at_once || end > n) fits = false;
        for (std::size_t i = begin; i < std::min(end, n); ++i) ++done[i];
      });
      CHECK(fits);
      for (const auto& times : done) REQUIRE(times == 1);
    }
  }
}

TEST_CASE("a crew passes on what the least item throws, and goes on") {
  Crew crew(3);
  for (int round = 0; round < 20; ++round) {
    std::string what;
    try {
      crew.each(8, [](std::size_t i) {
        if (i == 3 || i == 6) throw std::runtime_error(std::to_string(i));
      });
    } catch (const std::runtime_error& error) {
      what = error.what();
    }
    CHECK(what == "3");
    std::atomic<int> count{0};
    crew.each(5, [&](std::size_t) { ++count; });
    CHECK(count == 5);
  }
}
