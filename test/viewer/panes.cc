#include "model/panes.hh"

#include "catch.hh"

using namespace whittle::viewer;

TEST_CASE("each layout fills the area") {
  const Rect area{100, 50, 801, 600};
  for (const Layout layout : {Layout::side_by_side, Layout::split, Layout::original, Layout::result}) {
    View view;
    view.layout = layout;
    view.split = 0.3;
    int width = 0;
    for (const Pane& pane : panes(view, area, true)) {
      width += pane.seen.width;
      CHECK(pane.seen.height == area.height);
      CHECK(pane.picture.x <= pane.seen.x);
      CHECK(pane.picture.width >= pane.seen.width);
    }
    CHECK(width == area.width);
    const auto alone = panes(view, area, false);
    REQUIRE(alone.size() == 1);
    CHECK(alone[0].which == Which::original);
  }
}

TEST_CASE("the split line cuts two pictures of the same size") {
  View view;
  view.layout = Layout::split;
  view.split = 0.25;
  const Rect area{100, 50, 800, 600};
  const auto two = panes(view, area, true);
  REQUIRE(two.size() == 2);
  CHECK(split_column(view, area) == 300);
  CHECK(two[0].seen.width == 200);
  CHECK(two[1].seen.x == 300);
  CHECK(two[1].seen.width == 600);
  CHECK(two[0].picture.width == two[1].picture.width);
  view.split = 2;
  CHECK(panes(view, area, true)[1].seen.width == 0);
}
