#include "model/words.hh"

#include "catch.hh"
#include "model/number.hh"

using namespace whittle::viewer;
using Words = std::vector<std::string>;

TEST_CASE("command lines are split as a shell splits them") {
  CHECK(split_words("").empty());
  CHECK(split_words("  a  b\tc\n") == Words{"a", "b", "c"});
  CHECK(split_words("a 'b c' \"d 'e'\" f\\ g") == Words{"a", "b c", "d 'e'", "f g"});
  CHECK(split_words("a # the rest\nb") == Words{"a", "b"});
  CHECK(split_words("a#b") == Words{"a#b"});
  CHECK(split_words("a \\\n b") == Words{"a", "b"});
  CHECK(split_words("''") == Words{""});
  CHECK_THROWS_AS(split_words("a 'b"), WordsError);
}

TEST_CASE("a quoted word is split into the word that it was") {
  for (const std::string word :
       {"plain", "with blank", "it's", "", "fad:angle=30,pairs=all", "a#b", "$HOME", "0.5%"})
    CHECK(split_words(quote(word)) == Words{word});
  CHECK(quote("fad:angle=30") == "fad:angle=30");
}

TEST_CASE("numbers become the shortest text that reads back") {
  CHECK(whittle::text::shortest(0.8) == "0.8");
  CHECK(rounded(1234.567, 3) == 1230);
  CHECK(rounded(0.00123456, 4) == 0.001235);
  CHECK(to_number("1e-3") == 0.001);
  CHECK_FALSE(to_number("1x"));
  CHECK_FALSE(to_number(""));
  CHECK_FALSE(to_number("inf"));
  CHECK(grouped(0) == "0");
  CHECK(grouped(999) == "999");
  CHECK(grouped(1000) == "1,000");
  CHECK(grouped(1234567) == "1,234,567");
}
