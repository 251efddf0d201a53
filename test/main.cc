/// \file
/// The main function of every test program: Catch2's, except that a run which passes, but with test cases skipped, ends
/// with 77, which CTest lists as skipped.
#define CATCH_CONFIG_RUNNER
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_session.hpp>
#endif
#include "catch.hh"

int main(int argc, char** argv) {
  const int failed = Catch::Session().run(argc, argv);
  return failed == 0 && tests::is_skipped() ? 77 : failed;
}
