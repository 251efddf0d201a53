#include <limits>

#include "catch.hh"
#include "text/format.hh"
#include "text/hash.hh"
#include "text/number.hh"

using namespace whittle;

TEST_CASE("rounded numbers look as printf writes them") {
  CHECK(text::significant(0.001234, 6) == "0.001234");
  CHECK(text::significant(1.2e-5, 6) == "1.2e-05");
  CHECK(text::significant(123456789, 6) == "1.23457e+08");
  CHECK(text::significant(0, 6) == "0");
  CHECK(text::significant(-0.5, 3) == "-0.5");
  CHECK(text::significant(std::numeric_limits<double>::max(), 17) == "1.7976931348623157e+308");
}

TEST_CASE("formatted text may be empty and long") {
  CHECK(text::format("%s", "").empty());
  CHECK(text::format("%5d|%-4s|%.2f", 42, "a", 0.5) == "   42|a   |0.50");
  const std::string whole(10000, 'x');
  CHECK(text::format("%s", whole.c_str()) == whole);
}

TEST_CASE("a hash is FNV-1a") {
  CHECK(text::hash("") == "cbf29ce484222325");
  CHECK(text::hash("a") == "af63dc4c8601ec8c");
  CHECK(text::hash("foobar") == "85944171f73967e8");
}
