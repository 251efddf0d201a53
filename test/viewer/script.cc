#include "model/Script.hh"

#include "catch.hh"

using namespace whittle::viewer;
using Catch::Matchers::Contains;

TEST_CASE("a script is read line by line") {
  const auto commands =
      parse_script("# a tour\nopen 'my model.obj'\n\n  wait  # for it\nsplit 0.25\n", "tour");
  REQUIRE(commands.size() == 3);
  CHECK(commands[0].name == "open");
  CHECK(commands[0].arguments == std::vector<std::string>{"my model.obj"});
  CHECK(commands[0].place == "tour:2");
  CHECK(commands[1].name == "wait");
  CHECK(commands[2].number(0) == 0.25);
}

TEST_CASE("a script that makes no sense is refused with its place") {
  CHECK_THROWS_WITH(parse_script("wait\nopem x\n", "s"), Contains("s:2: unknown command 'opem'"));
  CHECK_THROWS_WITH(parse_script("open\n", "s"), Contains("usage: open FILE"));
  CHECK_THROWS_WITH(parse_script("wait 5\n", "s"), Contains("usage: wait"));
  CHECK_THROWS_WITH(parse_script("open 'x\n", "s"), Contains("s:1: a quote"));
}

TEST_CASE("a script's arguments are checked when they are used") {
  const auto command = parse_script("resize x 0\n", "s")[0];
  CHECK_THROWS_WITH(command.number(0), Contains("'x' is not a number"));
  CHECK_THROWS_WITH(command.count(1), Contains("at least 1"));
  CHECK_THROWS_WITH(command.on(0), Contains("neither on nor off"));
}

TEST_CASE("the script's help names every command") {
  for (const char* name : {"open", "slide", "screenshot", "expect-error", "close"})
    CHECK_THAT(script_help(), Contains(name));
}
