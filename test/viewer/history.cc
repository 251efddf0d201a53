#include "model/History.hh"

#include "catch.hh"

using whittle::viewer::History;

TEST_CASE("a history's undo goes back and its redo forth") {
  History<int> history(1);
  CHECK_FALSE(history.can_undo());
  history.change(2);
  history.change(3);
  history.undo();
  CHECK(history.now() == 2);
  history.undo();
  history.undo();
  CHECK(history.now() == 1);
  history.redo();
  CHECK(history.now() == 2);
  history.change(4);
  CHECK_FALSE(history.can_redo());
  history.undo();
  CHECK(history.now() == 2);
}

TEST_CASE("a history holds the changes of one drag as one step") {
  History<int> history(0);
  for (int i = 1; i < 10; ++i) history.change(i, "slider");
  history.undo();
  CHECK(history.now() == 0);
  history.redo();
  CHECK(history.now() == 9);
  history.change(10, "slider");  // another drag: an undo lay between
  history.undo();
  CHECK(history.now() == 9);
  history.change(20, "a");
  history.change(21, "b");
  history.change(22, "b");
  history.seal();
  history.change(23, "b");
  history.undo();
  CHECK(history.now() == 22);
  history.undo();
  CHECK(history.now() == 20);
}
