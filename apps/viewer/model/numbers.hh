/// \file
/// The figures as JSON, under the names that the command line gives them.
#pragma once

#include <nlohmann/json.hpp>

#include "model/Session.hh"

namespace whittle::viewer {

/// `command`, `original` and `simplified` (each `mesh` as of `whittle measure`), `stages`, `flipped_faces`,
/// `target_reached` as of `whittle simplify`, `distance` as of `whittle measure`. What is not there yet is
/// null.
nlohmann::ordered_json numbers(const Session& session);

}  // namespace whittle::viewer
