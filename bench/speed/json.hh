/// \file
/// A run in its written form; docs/speed.md describes the fields.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "speed/rounds.hh"

namespace whittle::speed {

using Json = nlohmann::ordered_json;

inline constexpr char kSchema[] = "whittle-speed";
inline constexpr int kSchemaVersion = 1;

/// Machine, build, libraries and settings, and no suite yet.
Json run_json(unsigned threads, const std::optional<std::string>& only);

/// One suite, to be added to the run's "suites".
Json suite_json(const Settings& settings, const std::vector<ModelResults>& models);

/// \throw std::runtime_error  the file cannot be read or is no run of this schema.
Json read_run(const std::filesystem::path& path);

}  // namespace whittle::speed
