/// \file
/// The code blocks of a page are the marked parts of a source, word for word and in the same order.
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "catch.hh"

namespace {

using Blocks = std::vector<std::string>;

Blocks lines_of(const std::string& path) {
  std::ifstream file(path);
  REQUIRE(file);
  Blocks lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

/// What stands between lines that begin a block and lines that end it.
template <typename Begins, typename Ends>
Blocks blocks(const Blocks& lines, Begins begins, Ends ends) {
  Blocks found;
  bool inside = false;
  for (const auto& line : lines) {
    if (!inside && begins(line)) {
      inside = true;
      found.emplace_back();
    } else if (inside && ends(line)) {
      inside = false;
    } else if (inside) {
      found.back() += line + "\n";
    }
  }
  CHECK_FALSE(inside);
  return found;
}

bool starts_with(const std::string& line, const std::string& start) {
  return line.compare(0, start.size(), start) == 0;
}

Blocks marked_parts(const Blocks& source) {
  return blocks(
      source, [](const auto& line) { return starts_with(line, "// ["); },
      [](const auto& line) { return starts_with(line, "// [/"); });
}

Blocks code_blocks(const Blocks& page) {
  return blocks(
      page, [](const auto& line) { return line == "```cpp"; },
      [](const auto& line) { return line == "```"; });
}

}  // namespace

TEST_CASE("marked parts and code blocks are found") {
  CHECK(marked_parts({"x", "// [a]", "1", "", "2", "// [/a]", "y", "// [b]", "3", "// [/b]"}) ==
        Blocks{"1\n\n2\n", "3\n"});
  CHECK(code_blocks({"text", "```cpp", "1", "```", "```sh", "no", "```", "```cpp", "```"}) ==
        Blocks{"1\n", ""});
}

TEST_CASE("the code of the page on planners is the code that was compiled") {
  const auto page = code_blocks(lines_of(WHITTLE_TUTORIAL_PAGE));
  const auto source = marked_parts(lines_of(WHITTLE_TUTORIAL_SOURCE));
  CHECK(source.size() == 6);
  CHECK(page == source);
}
