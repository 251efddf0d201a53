#include "speed/shapes.hh"

#include <algorithm>
#include <cstdint>
#include <regex>
#include <sstream>

#include "catch.hh"

using namespace whittle;

TEST_CASE("the shapes of the speed benchmark have the faces that are asked for, all of them in range") {
  for (const std::size_t n : {800u, 3200u}) {
    const auto all = speed::shapes(n);
    CHECK(all.size() == 8);
    for (const auto& shape : all) {
      CHECK(shape.mesh.triangles.size() == n);
      for (const auto& t : shape.mesh.triangles)
        for (const std::uint32_t v : t) REQUIRE(v < shape.mesh.points.size());
    }
  }
}

TEST_CASE("the page of shapes has a line for each time that is asked for") {
  std::ostringstream none;
  terminal::Progress progress(none, terminal::ProgressStyle::silent);
  const std::string page = speed::shapes_page(std::regex("^plane .*ivdd"), progress);
  CHECK(page.find("| plane | ivdd:distance=1e | ") != std::string::npos);
  CHECK(page.find("commit ") != std::string::npos);
  std::istringstream lines(page);
  int rows = 0;
  for (std::string line; std::getline(lines, line);) rows += line.rfind("| ", 0) == 0;
  CHECK(rows == 2);  // and a rule between them
}
