#include "fuzz/format.hh"

const whittle::files::Format whittle::fuzz::format = whittle::files::Format::WHITTLE_FUZZ_FORMAT;
