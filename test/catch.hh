/// \file
/// Catch2, version 2 or 3, and a test case that lacks something.
#pragma once

#include <iostream>
#include <string>

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif

namespace tests {

/// Whether a test case of this program has been skipped.
inline bool& is_skipped() {
  static bool skipped = false;
  return skipped;
}

/// Says that the test case lacks something; the caller returns then. The program ends with 77 unless something fails.
inline void skip(const std::string& reason) {
  std::cout << "skipped: " << reason << '\n';
  is_skipped() = true;
}

}  // namespace tests
