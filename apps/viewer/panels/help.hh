/// \file
#pragma once

#include "panels/Ui.hh"

namespace whittle::viewer {

/// Mouse, keys and the few settings, as the inside of a dialog.
void help(Ui& ui);

}  // namespace whittle::viewer
