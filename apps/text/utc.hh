/// \file
/// Points in time as text.
#pragma once

#include <string>

namespace whittle::text {

/// The present time, as ISO 8601 in UTC: `2026-07-28T09:30:00Z`.
std::string now_utc();

}  // namespace whittle::text
