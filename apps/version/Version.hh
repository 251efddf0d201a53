/// \file
/// What this build is.
#pragma once

#include <string>

namespace whittle::version {

std::string number();  ///< "0.2.0"
std::string commit();  ///< of the sources; "unknown" where they are no git checkout
bool dirty();          ///< whether they differed from it

/// For `--version`: program, number and commit, and the libraries, one a line.
std::string text(const std::string& program);

}  // namespace whittle::version
