/// \file
/// One module of the chain, with its parameters.
#pragma once

#include <cstddef>

#include "panels/Ui.hh"

namespace whittle::viewer {

/// \return whether modules were added, removed or moved.
bool draw_module_card(Ui& ui, std::size_t place);

}  // namespace whittle::viewer
