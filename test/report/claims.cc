#include "catch.hh"
#include "example.hh"
#include "papers/Papers.hh"
#include "papers/Verdict.hh"

using namespace whittle;
using bench::Word;

namespace {

const bench::Verdict& find(const std::vector<bench::Verdict>& all, const std::string& begin) {
  for (const auto& verdict : all)
    if (verdict.claim.rfind(begin, 0) == 0) return verdict;
  FAIL("no claim begins with " << begin);
  return all.front();
}

}  // namespace

TEST_CASE("a claim holds near it or where the spread covers it") {
  CHECK(bench::judge(30, {30, 29, 31}, 10) == Word::holds);
  CHECK(bench::judge(30, {37, 36, 38}, 10) == Word::holds);
  CHECK(bench::judge(30, {38, 37, 39}, 10) == Word::more);
  CHECK(bench::judge(30, {50, 29, 60}, 10) == Word::holds);
  CHECK(bench::judge(30, {22, 21, 23}, 10) == Word::less);
  CHECK(bench::judge(30, {-5, -6, -4}, 10) == Word::fails);
}

TEST_CASE("a claim is undecided where the spread exceeds the effect, or with one repetition") {
  CHECK(bench::judge(2, {2, 0, 5}, 10) == Word::undecided);
  CHECK(bench::judge(30, {30, 30, 30}, 1) == Word::undecided);
}

TEST_CASE("an algorithm's improvement is the mean of its sets in each repetition") {
  auto e = example::paper1();
  e.sets[3].visits[0].wall_ms = 50;  // FAD 150: 100 % in the first repetition, 25 % in the second
  const auto fad = bench::mean_improvement(e, "FAD");
  REQUIRE(fad);
  CHECK(fad->min == Approx(25));
  CHECK(fad->max == Approx(62.5));
  CHECK_FALSE(bench::mean_improvement(e, "SS"));
  e.sets[3].visits.clear();
  CHECK_FALSE(bench::mean_improvement(e, "FAD"));
}

TEST_CASE("each claim has what was measured, the ratio and a word") {
  const auto all = bench::verdicts(example::results());
  const auto& vt = find(all, "VT raises");
  CHECK(vt.measured == "100.0 %");
  CHECK(vt.ratio == "3.30");
  CHECK(vt.word == Word::more);
  CHECK(find(all, "FAD raises").word == Word::holds);
  // 11 % in one repetition and -20 % in the other.
  CHECK(find(all, "IVDD raises").word == Word::undecided);
  CHECK(find(all, "FAD at 30").word == Word::fails);
  CHECK(find(all, "FAD at 30").measured == "250 and 260 triangles removed");
}

TEST_CASE("the numbers of Paper 2 are compared as thirds") {
  const auto& angles = bench::papers::angles();
  auto results = example::results();
  auto& e = results.experiments[0];
  e.name = "paper2";
  e.sets = {example::timed(example::original(), 968, {16, 16})};
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const std::size_t removed = (angles[0].triangles - angles[i].triangles) / 3;
    e.sets.push_back(example::timed(
        {angles[i].set + "-literal", "", "FAD", "", "fad", angles[i].set, bench::Role::literal},
        968 - removed, {15.5, 15.5}));
  }
  const auto all = bench::verdicts(results);
  CHECK(find(all, "> 30° removes 114 of 968").ratio == "1.00");
  CHECK(find(all, "> 150° removes 24 of 968").word == Word::holds);
  CHECK(find(all, "the smaller the angle").measured == "114, 110, 71, 24 triangles");
  CHECK(find(all, "the smaller the angle").word == Word::holds);
  CHECK(find(all, "> 30° renders").measured == "3.2 %");
}
