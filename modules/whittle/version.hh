/// \file
/// The version of Whittle, for the preprocessor. The build reads it here: it stands nowhere else.
#pragma once

#define WHITTLE_VERSION_MAJOR 0
#define WHITTLE_VERSION_MINOR 2
#define WHITTLE_VERSION_PATCH 0

/// One number to compare with: 10000 major + 100 minor + patch; 200 is 0.2.0.
#define WHITTLE_VERSION (10000 * WHITTLE_VERSION_MAJOR + 100 * WHITTLE_VERSION_MINOR + WHITTLE_VERSION_PATCH)
