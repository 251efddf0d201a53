/// \file
/// Everything that a run of the benchmark finds out, as it stands in results.json: raw times, counts, errors.
/// Medians and comparisons are formed from it (Figures.hh) and never stored alone.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace whittle::bench {

/// What a set is there for.
enum class Role {
  paper,    ///< a set of the paper, run with Whittle's defaults (the original too)
  literal,  ///< the same by the paper's literal words
  curve,    ///< one threshold of many
  peer,     ///< another simplifier, brought to the triangle count of `compared_with`
  cache     ///< `compared_with`, its triangles in vertex-cache order
};

/// What to make of the original. The original itself has neither recipe nor `compared_with`.
struct SetDefinition {
  static constexpr const char* kRefitSuffix = " --refit";

  std::string name;           ///< on the command line and in file names; unique in its experiment
  std::string label;          ///< for readers
  std::string algorithm;      ///< "VT", "FAD", …; the peer's name; empty for the original
  std::string parameter;      ///< short, for the axis of a chart: "30°"
  std::string recipe;         ///< a module specification, refitted with kRefitSuffix; "peer:NAME" for a peer
  std::string compared_with;  ///< the set that a literal, peer or cache set belongs to
  Role role = Role::paper;

  bool original() const { return recipe.empty() && compared_with.empty(); }
};

/// How far a set's surface and its pictures are from the original's. Lengths in model units.
struct Fidelity {
  double rms = 0, mean = 0, max = 0;                       ///< two-sided
  double normal_mean_degrees = 0, normal_max_degrees = 0;  ///< NormalDeviation
  double quality_mean = 0, quality_p05 = 0;                ///< 4√3·area/(a²+b²+c²); 1 is equilateral
  double psnr_db = 0, psnr_worst_db = 0;                   ///< over all views; the worst view
  double ssim = 0, ssim_worst = 0;                         ///< mean of the views; the worst view
};

/// One visit to a set: a span of frames.
struct Visit {
  std::size_t repetition = 0;   ///< from 1
  std::size_t start = 1;        ///< of the program: 1, and one more for each --resume
  std::size_t visited_as = 0;   ///< place in the repetition, from 1
  double wall_ms = 0;           ///< all timed frames, steady clock between two glFinish
  std::optional<double> gl_ms;  ///< the same span by GL_TIME_ELAPSED
};

/// File names relative to the results; empty where there is no such picture.
struct PictureNames {
  std::string whole, detail, heat;
};

struct SetResult {
  SetDefinition definition;
  std::size_t vertices = 0, triangles = 0;
  std::size_t flipped_faces = 0, nonmanifold_edges = 0;
  double decimation_ms = 0;              ///< planning and execution, without reading the file
  double cache_misses_per_triangle = 0;  ///< of a FIFO cache of 16 vertices, in the order drawn
  std::optional<Fidelity> fidelity;
  PictureNames pictures;
  std::string note;  ///< what went wrong, if anything did
  std::vector<Visit> visits;
  bool made = false;  ///< the counts above are filled in
};

/// The mesh that an experiment starts from.
struct ModelFacts {
  std::string label, kind, file;
  std::size_t vertices = 0, triangles = 0;
  double mean_edge = 0, diagonal = 0;  ///< model units
  std::vector<std::string> notes;
};

struct Timing {
  std::size_t frames_from = 100, frames_to = 1100;  ///< timed are [from, to)
  std::size_t repetitions = 10;
  std::size_t frames_timed() const { return frames_to - frames_from; }
};

struct ExperimentResult {
  std::string name;  ///< "paper1", "paper2", "beyond"
  ModelFacts model;
  Timing timing;
  double heat_scale = 0;        ///< the distance painted red in the heat maps, model units
  std::vector<SetResult> sets;  ///< the original first
};

struct Settings {
  int width = 256, height = 256;  ///< of the timed image, pixels
  std::size_t views = 6;          ///< compared by PSNR and SSIM
  std::size_t samples = 200000;   ///< a side, for distances
};

/// Facts of the machine and the build. Whatever cannot be found out is "unknown".
struct Environment {
  std::string gl_renderer, gl_vendor, gl_version, egl_device;
  std::string cpu_model;
  unsigned cpu_threads = 0;  ///< that the process may use
  std::string compiler, build_type;
  std::string commit;         ///< of the source tree when the program was built
  bool commit_dirty = false;  ///< there were changes beside the commit
  std::string date_utc;       ///< ISO 8601, of the first start
};

struct Results {
  std::string protocol;  ///< "quick", "paper", "custom"
  bool complete = false;
  std::size_t starts = 1;  ///< of the program; more than one after --resume
  Settings settings;
  Environment environment;
  std::vector<std::string> notes;
  std::vector<ExperimentResult> experiments;
};

/// The experiment or set of that name, or null.
/// \{
const ExperimentResult* find(const Results& results, const std::string& experiment);
const SetResult* find(const ExperimentResult& experiment, const std::string& set);
SetResult* find(ExperimentResult& experiment, const std::string& set);
/// \}

}  // namespace whittle::bench
