/// \file
/// Who takes part.
#pragma once

#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "speed/Contender.hh"

namespace whittle::speed {

enum class Suite {
  figures,  ///< all contenders, on models of ordinary size
  growth,   ///< sweep, bulk and meshopt_simplify, on models of growing size
  truth     ///< mq, meshopt_simplify and CGAL's Lindstrom-Turk down to many shares, with their topology
};

std::string to_string(Suite suite);

/// The contenders of a suite for one model. Runs each planned module once, to learn its number of faces.
/// \param only  keeps those in whose name it is found.
std::vector<Entry> lineup(Suite suite, const Subject& subject, const std::optional<std::regex>& only);

}  // namespace whittle::speed
