/// \file
/// OBJ read in pieces: what comes of it is what the reader of single lines makes.
#include "files/ObjPieces.hh"

#include <cstring>
#include <functional>
#include <random>

#include "files/FastNumber.hh"
#include "files/TextReader.hh"
#include "samples.hh"

namespace whittle::files {
namespace {

/// Bit for bit what the reader of words makes of a number.
template <typename Real>
bool reads_as_words_do(const std::string& text) {
  const char* at = text.data();
  Real fast = 0;
  if (!read_fast(at, text.data() + text.size(), fast) || at != text.data() + text.size()) return false;
  const Real slow = parse_real<Real>(text);
  return std::memcmp(&fast, &slow, sizeof(Real)) == 0;
}

/// A file whose lines are of all kinds that are read in pieces, longer than several pieces.
std::string long_obj(const std::string& line_end) {
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) { return std::to_string(random() % n); };
  std::string text = "# head\\\nmtllib a.mtl" + line_end;
  constexpr std::size_t vertices = 9000;
  for (std::size_t i = 0; i < vertices; ++i) {
    text += "v " + below(100) + "." + below(1000000) + " -" + below(7) + "e-" + below(9) + "\t" +
            below(100000000) + below(100000000) + below(1000) + "  " + line_end;
    if (i % 3 == 0) text += "vt 0." + below(1000000) + " " + below(2) + (i % 2 ? " 0" : "") + line_end;
    if (i % 4 == 0) text += " vn 0 -.5 " + below(3) + ". # normal" + line_end;
    if (i % 1000 == 0) text += line_end + "# a comment" + line_end;
  }
  for (std::size_t i = 0; i < 20000; ++i) {
    if (i % 2000 == 0) text += "usemtl  stone " + below(3) + " " + line_end;
    if (i % 3000 == 5) text += "g " + below(2) + line_end + "s off" + line_end;
    text += "f";
    const std::size_t style = i < 10000 ? random() % 5 : 0;
    for (int k = 0; k < 3; ++k) {
      const std::string v = std::to_string(1 + random() % vertices), t = std::to_string(1 + random() % 3000),
                        n = std::to_string(1 + random() % 2250);
      const std::string corners[] = {v, v + "/" + t, v + "//" + n, v + "/" + t + "/" + n, v + "//"};
      text += " " + (i % 50 == 0 ? std::string("1") : corners[style]);
    }
    text += line_end;
  }
  return text;
}

void check_same(const MeshFile& a, const MeshFile& b) {
  REQUIRE(same_bits<double>(a.mesh, b.mesh));
  REQUIRE(a.attributes.size() == b.attributes.size());
  for (std::size_t i = 0; i < a.attributes.size(); ++i)
    CHECK(same_attribute(a.attributes[i], b.attributes[i], a.mesh));
  CHECK(a.parts.of_face == b.parts.of_face);
  CHECK(a.parts.list.size() == b.parts.list.size());
  CHECK(a.parts.materials.size() == b.parts.materials.size());
  CHECK(a.report.dropped_degenerate == b.report.dropped_degenerate);
  CHECK(a.report.missing_values == b.report.missing_values);
}

bool in_pieces(const std::string& text) {
  ObjLists lists;
  return read_obj_in_pieces(text, lists);
}

}  // namespace

TEST_CASE("OBJ in pieces: a file of all that is read so comes out as line by line") {
  const Folder folder;
  for (const char* line_end : {"\n", "\r\n"}) {
    const std::string text = long_obj(line_end);
    REQUIRE(text.size() > 4 * 65536);
    REQUIRE(in_pieces(text));
    const std::string and_a_line = text + "l 1 2\n";
    REQUIRE_FALSE(in_pieces(and_a_line));
    check_same(folder.read("a.obj", text), folder.read("b.obj", and_a_line));
    // Without its last line end.
    const std::string cut = text.substr(0, text.size() - std::strlen(line_end));
    check_same(folder.read("a.obj", cut), folder.read("b.obj", and_a_line));
  }
}

TEST_CASE("OBJ in pieces: what is something else is left to the reader of lines") {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 1\n";
  CHECK(in_pieces(triangle + "f 1 2 3\n"));
  CHECK(in_pieces("\xEF\xBB\xBF" + triangle + "\n \n# f 1\n\tf 1/1 2/1/ 3//"));
  CHECK(in_pieces(""));
  for (const char* other :
       {"f 1 2 4",          "f 0 1 2",          "f -1 -2 -3", "f 1 2",      "f 1 2 3 1",   "f 1/2 2 3",
        "f 1 2 3//1",       "f 1/1/1/1 2 3",    "f 1 2 3x",   "f 1 2 3 \\", "f +1 2 3",    "v 0 0",
        "v 0 0 0 1",        "v 0 0 0 1 1 1",    "v 0 0 nan",  "v 0 0 inf",  "v 0 0 1e999", "v 0 0 1e",
        "v 0 0 0x1",        "v 0 0 +1",         "v 0 0 .",    "v 0 0 -",    "v0 0 0",      "vt 0",
        "vt 0 0 1",         "vn 0 0",           "p 1",        "mg 1",       "bad",         "g a\\",
        "f 4294967296 1 2", "f 99999999999 1 2"}) {
    INFO(other);
    CHECK_FALSE(in_pieces(triangle + other + "\n"));
    CHECK_FALSE(in_pieces(triangle + other));
  }
}

TEST_CASE("OBJ in pieces: lines that are too short for their kind make no room") {
  std::string text;
  for (int i = 0; i < 100000; ++i) text += "f 1\n";
  ObjLists lists;
  CHECK_FALSE(read_obj_in_pieces(text, lists));
  CHECK(lists.triangles.capacity() == 0);
}

TEST_CASE("numbers: read fast they are those of the reader of words, to the last bit") {
  for (const char* text : {"0",
                           "-0",
                           "1",
                           "-1.5",
                           ".5",
                           "5.",
                           "0.1",
                           "1e5",
                           "1E-5",
                           "1e+05",
                           "123456789012345678",
                           "1234567890123456789012",
                           "0.000000000000000000000000012345",
                           "9007199254740993",
                           "9007199254740992",
                           "4.35",
                           "16777217",
                           "16777217.0000001",
                           "0.500000029802322387695",
                           "1.00000005960464477539",
                           "1.1754943e-38",
                           "1e-310",
                           "1e300",
                           "3.4028235e38",
                           "2.2250738585072011e-308",
                           "1e22",
                           "1e23",
                           "0e999",
                           "000000000000000000000000.1"}) {
    INFO(text);
    CHECK(reads_as_words_do<double>(text));
    const double size = std::abs(parse_real<double>(text));
    if (size == 0 || (size > 1.2e-38 && size < 3.4e38)) CHECK(reads_as_words_do<float>(text));
  }
  std::mt19937 random(3);
  std::size_t wrong = 0;
  for (int i = 0; i < 100000; ++i) {
    std::string text = random() % 2 ? "-" : "";
    for (std::size_t n = 1 + random() % 10; n > 0; --n) text += static_cast<char>('0' + random() % 10);
    text += '.';
    for (std::size_t n = random() % 12; n > 0; --n) text += static_cast<char>('0' + random() % 10);
    if (random() % 4 == 0) text += "e" + std::to_string(static_cast<int>(random() % 40) - 20);
    wrong += !reads_as_words_do<double>(text) || !reads_as_words_do<float>(text);
  }
  CHECK(wrong == 0);
}

}  // namespace whittle::files
