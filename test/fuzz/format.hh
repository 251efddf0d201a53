/// \file
/// What a fuzz target of a reader reads: the build gives each target a format.cc of its own.
#pragma once

#include "files/formats.hh"

namespace whittle::fuzz {

extern const files::Format format;

}  // namespace whittle::fuzz
