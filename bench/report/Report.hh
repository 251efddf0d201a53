/// \file
/// Everything a run found out, and its two written forms.
#pragma once

#include <string>
#include <vector>

#include "experiment/Environment.hh"
#include "experiment/Experiment.hh"

namespace whittle::bench {

struct Report {
  const Model& model;
  const Settings& settings;
  const Environment& environment;
  const std::vector<SetResult>& sets;  ///< the original first
};

/// The files of a set's pictures, within the output folder.
std::string picture_name(const SetDefinition& set);
std::string ears_picture_name(const SetDefinition& set);

/// What stands under a picture.
std::string caption(const Model& model, const SetDefinition& set);

/// Every raw time and every figure, each named with its unit; docs/benchmark.md describes the fields.
std::string json_text(const Report& report);

/// A page to read: the machine, the table, the pictures.
std::string markdown_text(const Report& report);

}  // namespace whittle::bench
