#include "text/printable.hh"

#include "catch.hh"

using whittle::text::printable;

TEST_CASE("printable text is the same where it harms no terminal, in any script") {
  for (const std::string text :
       {"", "bunny.ply", "a b \\ ~", "\xC3\xA9t\xC3\xA9", "\xE6\xA8\xA1\xE5\x9E\x8B.obj", "\xF0\x9F\x90\x87"})
    CHECK(printable(text) == text);
}

TEST_CASE("printable text has no control characters, line breaks and marks of direction") {
  CHECK(printable("a\nb\rc\td") == "a\\nb\\rc\\td");
  CHECK(printable("\x1b[31mred\x7f") == "\\x1b[31mred\\x7f");
  CHECK(printable(std::string("a\0b", 3)) ==
        "a\\x00"
        "b");
  CHECK(printable("\xC2\x9B"
                  "31m") == "\\x9b31m");  // a control sequence in one character
  CHECK(printable("\xE2\x80\xAE"
                  "ylp\xE2\x80\xA8") == "\\u{202e}ylp\\u{2028}");
}

TEST_CASE("printable text is UTF-8: each byte that is not is written as a number") {
  CHECK(printable("a\xff.ply") == "a\\xff.ply");
  CHECK(printable("\xC3") == "\\xc3");           // cut off
  CHECK(printable("\xC0\xAF") == "\\xc0\\xaf");  // not the shortest form
  CHECK(printable("\xE0\x80\xAF") == "\\xe0\\x80\\xaf");
  CHECK(printable("\xED\xA0\x80") == "\\xed\\xa0\\x80");           // half of a surrogate pair
  CHECK(printable("\xF4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");  // beyond the last
  CHECK(printable("\xC3(") == "\\xc3(");
}
