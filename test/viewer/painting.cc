#include "model/Painting.hh"

#include <vector>

#include "catch.hh"

using namespace whittle::viewer;

namespace {

/// Strokes that note what is drawn, and a clock that reports how long it took.
struct Easel {
  double now = 0, milliseconds_each = 0.001;
  std::vector<std::vector<int>> drawn;  ///< for each stroke how often each of its parts was drawn
  std::vector<std::size_t> pieces;

  Painting painting(const std::vector<std::size_t>& sizes) {
    std::vector<Stroke> strokes;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      drawn.emplace_back(sizes[i], 0);
      strokes.push_back({sizes[i], [this, i](std::size_t first, std::size_t count) {
                           pieces.push_back(count);
                           for (std::size_t j = first; j < first + count; ++j) ++drawn[i].at(j);
                           now += milliseconds_each * static_cast<double>(count);
                         }});
    }
    return Painting(strokes);
  }
  Painting::Clock clock() {
    return [this] { return now; };
  }
  bool all_once() const {
    for (const auto& stroke : drawn)
      for (const int times : stroke)
        if (times != 1) return false;
    return true;
  }
};

}  // namespace

TEST_CASE("a picture in pieces is the whole picture, each part once") {
  for (const double budget : {0.0, 1.0, 30.0}) {
    Easel easel;
    Painting painting = easel.painting({1, 0, 50000, 1, 1234, 0});
    std::size_t turns = 0;
    for (; !painting.done(); ++turns) painting.advance(budget, easel.clock());
    CHECK(easel.all_once());
    CHECK(painting.milliseconds() == Approx(easel.now));
    if (budget == 30) CHECK(turns < 4);
    if (budget == 1) CHECK(turns > 30);
  }
}

TEST_CASE("one turn of painting takes its time limit, however slow drawing is") {
  for (const double each : {1e-6, 1e-3, 0.02}) {
    Easel easel;
    easel.milliseconds_each = each;
    Painting painting = easel.painting({1, 2000000});
    painting.advance(30, easel.clock());  // the first piece is a guess
    while (!painting.done()) {
      const double before = easel.now;
      painting.advance(30, easel.clock());
      CHECK(easel.now - before < 40);
      if (!painting.done()) CHECK(easel.now - before > 20);
      if (each > 0.01 && easel.now > 1000) break;
    }
  }
}

TEST_CASE("a picture that draws quickly is drawn in few pieces") {
  Easel easel;
  easel.milliseconds_each = 1e-6;
  Painting painting = easel.painting({1000000});
  painting.advance(30, easel.clock());
  CHECK(painting.done());
  CHECK(easel.pieces.size() < 8);
}

TEST_CASE("a picture can be finished at once, and an empty one is done") {
  Easel easel;
  Painting painting = easel.painting({1, 5000, 0, 7});
  painting.advance(0, easel.clock());
  painting.finish();
  CHECK(painting.done());
  CHECK(easel.all_once());
  CHECK(Painting().done());
  CHECK(easel.painting({0, 0}).done());
}
