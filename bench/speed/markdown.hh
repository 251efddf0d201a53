/// \file
/// A page to read, made of one run or several.
#pragma once

#include <string>
#include <vector>

#include "speed/json.hh"

namespace whittle::speed {

/// Machine and build of each run, the goals, and a table for each model. Everything is taken from the JSON.
std::string markdown(const std::vector<Json>& runs);

}  // namespace whittle::speed
