/// \file
/// Figures as texts for tables.
#pragma once

#include <string>

#include "results/Statistics.hh"

namespace whittle::bench {

/// With so many decimals.
std::string fixed(double value, int decimals);

/// A whole number with commas: "34,835".
std::string thousands(double value);

/// Three significant digits, for errors: "4.27e-05", "0.0131".
std::string short_number(double value);

/// "12.3 (11.8 to 12.9)": the median, then the spread; the median alone where there is none.
std::string spread_text(const Summary& summary, int decimals);

}  // namespace whittle::bench
