/// \file
/// No code block of a page or of a header goes untested, and no link of a page leads nowhere.
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "Folder.hh"
#include "catch.hh"
#include "whittle/version.hh"

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

TEST_CASE("pages: each link to a file of the repository leads to one") {
  const std::filesystem::path root = WHITTLE_DOCS_TESTS "/../..";
  std::vector<std::filesystem::path> pages;
  for (const char* folder : {"", "assets", "docs", "docs/benchmarks", "docs/modules"})
    for (const auto& entry : std::filesystem::directory_iterator(root / folder))
      if (entry.path().extension() == ".md") pages.push_back(entry.path());
  REQUIRE(pages.size() > 20);

  const std::regex link(R"(\]\(([^)#: ]+)(#[^)]*)?\))");
  std::size_t n_links = 0;
  for (const auto& page : pages) {
    std::ifstream in(page);
    bool is_code = false;
    for (std::string line; std::getline(in, line);) {
      if (line.compare(0, 3, "```") == 0) is_code = !is_code;
      if (is_code) continue;
      for (std::sregex_iterator it(line.begin(), line.end(), link), end; it != end; ++it, ++n_links) {
        INFO(page << ": " << (*it)[1]);
        CHECK(std::filesystem::exists(page.parent_path() / (*it)[1].str()));
      }
    }
  }
  CHECK(n_links > 50);
}

TEST_CASE("pages: citation and changelog name the version of the header") {
  const std::string root = WHITTLE_DOCS_TESTS "/../../";
  const std::string version = std::to_string(WHITTLE_VERSION_MAJOR) + "." +
                              std::to_string(WHITTLE_VERSION_MINOR) + "." +
                              std::to_string(WHITTLE_VERSION_PATCH);
  CHECK_THAT(scratch::contents(root + "CITATION.cff"), Catch::Contains("\nversion: " + version + "\n"));
  CHECK_THAT(scratch::contents(root + "CHANGELOG.md"), Catch::Contains("\n## " + version + " ("));
}
