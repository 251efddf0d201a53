/// \file
/// No code block of a page or of a header goes untested.
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "Folder.hh"
#include "catch.hh"

TEST_CASE("pages: each code block has a name and a test") {
  std::istringstream tested(WHITTLE_TESTED_BLOCKS);
  std::set<std::string> untouched;
  for (std::string name; tested >> name;) untouched.insert(name);
  REQUIRE_FALSE(untouched.empty());

  std::ifstream index(WHITTLE_BLOCKS "/index");
  REQUIRE(index);
  for (std::string name, language, place; index >> name >> language >> place;) {
    INFO(place << ": put <!-- test: NAME --> above the block, and its test into test/docs");
    CHECK(name != "-");
    const bool is_tested = untouched.erase(name) == 1;
    CHECK(is_tested);
    if (language == "cpp") {
      bool is_included = false;
      for (const char* source : {"pages.cc", "planner.cc", "chart.cc"}) {
        const std::string text = scratch::contents(std::string(WHITTLE_DOCS_TESTS "/") + source);
        is_included = is_included || text.find("#include \"" + name + ".inc\"") != std::string::npos;
      }
      CHECK(is_included);
    }
  }
  for (const auto& name : untouched)
    FAIL_CHECK("test/docs/CMakeLists.txt lists a block that no page has: " << name);
}
