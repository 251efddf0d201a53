/// \file
/// How many processors the process uses.
#pragma once

namespace whittle::speed {

/// Those that the process may use now.
unsigned allowed_threads();

/// Confines the whole process, all contenders alike, to that many of them.
/// \throw std::runtime_error  there are not so many, or the system refuses.
void confine(unsigned threads);

}  // namespace whittle::speed
