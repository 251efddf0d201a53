#include "speed/markdown.hh"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "speed/figures.hh"
#include "speed/textured/suite.hh"

namespace whittle::speed {
namespace {

std::string number(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

/// Three significant digits, no exponent.
std::string short_number(double value) {
  const double magnitude = std::abs(value);
  const int before = magnitude >= 1 ? static_cast<int>(std::log10(magnitude)) + 1 : 1;
  return number(value, before >= 3 ? 0 : 3 - before);
}

std::string text(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string core_of(const Json& run) {
  return text(run.at("openmesh_core").at("label"));
}

void write_run(std::ostream& out, const Json& run) {
  const Json& build = run.at("build");
  out << "- OpenMesh's core **" << core_of(run) << "**, " << text(run.at("date_utc")) << ": "
      << text(run.at("machine").at("cpu_model")) << ", " << run.at("settings").at("threads") << " threads, "
      << number(run.at("machine").at("memory_bytes").get<double>() / (1u << 30), 0) << " GiB; "
      << text(build.at("compiler")) << ", `" << text(build.at("flags")) << "`; commit "
      << text(build.at("git_commit")) << (build.at("git_dirty") == true ? " with changes" : "");
  for (const auto& [name, version] : run.at("libraries").items()) out << "; " << name << " " << text(version);
  if (!run.at("settings").at("only").is_null())
    out << "; only `" << text(run.at("settings").at("only")) << "`";
  out << "\n";
  for (const Json& suite : run.at("suites")) {
    out << "  - " << text(suite.at("suite")) << ", " << suite.at("rounds") << " rounds:";
    const char* separator = " ";
    for (const Json& model : suite.at("models")) {
      out << separator << text(model.at("name")) << " (" << model.at("vertices") << " vertices, "
          << model.at("faces") << " triangles";
      if (model.contains("checksum")) out << ", checksum " << text(model.at("checksum"));
      out << ")";
      separator = ", ";
    }
    out << "\n";
  }
}

void write_figures(std::ostream& out, const std::vector<Json>& runs) {
  if (std::all_of(runs.begin(), runs.end(), [](const Json& run) { return figures(run).empty(); })) return;
  out << "## Goals\n\nRatios of medians within one run. A goal is reached if each of its ratios is.\n\n"
      << "| what | against | on | core | goal | measured | reached |\n|---|---|---|---|---|---|---|\n";
  for (const Json& run : runs)
    for (const Figure& f : figures(run)) {
      const bool times_faster = f.bound == Figure::Bound::at_least;
      out << "| " << f.what << " | " << f.against << " | " << f.model << " | " << f.core << " | "
          << (times_faster ? "≥ " : "≤ ") << f.goal << (times_faster ? "× faster" : "×") << " | ";
      const char* separator = "";
      for (const Ratio& ratio : f.ratios) {
        out << separator << ratio.of << " " << (f.reached(ratio) ? "" : "**") << short_number(ratio.value)
            << "×" << (f.reached(ratio) ? "" : "**")
            << (ratio.remark.empty() ? "" : " (" + ratio.remark + ")");
        separator = ", ";
      }
      out << " | " << (f.reached() ? "yes" : "**no**") << " |\n";
    }
  out << "\n";
}

/// Errors of ours against each peer's over all models: of each share of the faces the geometric mean and the worst.
void write_means(std::ostream& out, const Json& suite) {
  const std::vector<MeanRatio> means = mean_ratios(suite);
  if (means.empty()) return;
  out << "## Over all models\n\nThe error as a multiple of the peer's: the geometric mean over so many "
         "models, then the worst. Where their faces differ by more than two percent a model is left out; "
         "what is below a millionth of the diagonal counts as that.\n\n"
      << "| ours | peer | error | of the faces | models | mean | worst | on "
         "|\n|---|---|---|---|--:|--:|--:|---|\n";
  for (const MeanRatio& mean : means)
    out << "| " << mean.ours << " | " << mean.peer << " | " << mean.error << " | " << mean.share << " | "
        << mean.models << " | " << number(mean.geometric_mean, 3) << " | " << number(mean.worst, 2) << " | "
        << mean.worst_model << " |\n";
  out << "\n";
}

/// "1.23 (1.20..1.31)" in milliseconds: the median and the quartiles.
std::string milliseconds(const Json& times) {
  if (times.is_null()) return "";
  const auto ms = [&](const char* key) { return short_number(1000 * times.at(key).get<double>()); };
  return ms("median") + " (" + ms("lower_quartile") + ".." + ms("upper_quartile") + ")";
}

std::string median_milliseconds(const Json& times) {
  return times.is_null() ? "" : short_number(1000 * times.at("median").get<double>());
}

/// \param limit  the least RMS distance times faces, in percent of the diagonal
void write_score(std::ostream& out, const Json& score, double limit) {
  if (score.is_null()) {
    out << " | | | | | | |";
    return;
  }
  out << " " << score.at("faces") << " |";
  const Json& distance = score.at("distance");
  if (distance.is_null())
    out << " | | | | |";
  else
    out << " " << number(distance.at("rms_percent_of_diagonal"), 4) << " | "
        << (limit > 0 ? short_number(distance.at("rms_percent_of_diagonal").get<double>() *
                                     score.at("faces").get<double>() / limit)
                      : "")
        << " | " << number(distance.at("mean_percent_of_diagonal"), 4) << " | "
        << number(distance.at("max_percent_of_diagonal"), 3) << " | " << distance.at("flipped_faces") << " |";
  out << " " << score.at("nonmanifold_edges") << " |";
}

void write_model(std::ostream& out, const Json& run, const Json& suite, const Json& model) {
  out << "## " << text(model.at("name")) << ", " << text(suite.at("suite")) << ", core " << core_of(run)
      << "\n\n"
      << model.at("faces") << " triangles";
  if (model.at("faces_refused_by_openmesh") != 0)
    out << ", of which OpenMesh does not take " << model.at("faces_refused_by_openmesh");
  out << ". Times in milliseconds, median (quartiles); distances in percent of the diagonal, two-sided. "
         "RMS / limit: in how many times the least that so many triangles can have, were the model "
         "smooth.\n\n"
      << "| contender | decimation, ms | load | unload | faces | RMS | RMS / limit | mean | max | flipped | "
         "non-manifold edges | peak / loaded memory |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const Json& result : model.at("results")) {
    out << "| " << text(result.at("name")) << " | " << milliseconds(result.at("seconds")) << " | "
        << median_milliseconds(result.at("load_seconds")) << " | "
        << median_milliseconds(result.at("unload_seconds")) << " |";
    write_score(out, result.at("score"), model.value("smooth_limit_percent_of_diagonal", 0.0));
    const Json& memory = result.at("memory");
    const double loaded = memory.is_null() ? 0 : memory.at("loaded_bytes").get<double>();
    out << " " << (loaded > 0 ? short_number(memory.at("peak_bytes").get<double>() / loaded) : "") << " |\n";
  }
  out << "\n";
}

/// What of the topology each result has kept, where the model itself was looked at.
void write_topology(std::ostream& out, const Json& model) {
  const Json input = model.value("input", Json());
  if (input.is_null()) return;
  out << "| | Euler characteristic | boundary loops | pieces | non-manifold vertices | self-intersections "
         "|\n|---|--:|--:|--:|--:|--:|\n";
  const auto row = [&](const std::string& name, const Json& score) {
    out << "| " << name;
    for (const char* key : {"euler_characteristic", "boundary_loops", "components", "nonmanifold_vertices",
                            "self_intersections"})
      out << " | " << (score.at(key).is_null() ? "" : score.at(key).dump());
    out << " |\n";
  };
  row("the model", input);
  for (const Json& result : model.at("results"))
    if (!result.at("score").is_null()) row(text(result.at("name")), result.at("score"));
  out << "\n";
}

/// The phases of the contenders that report them.
void write_phases(std::ostream& out, const Json& model) {
  const Json* copy = nullptr;
  for (const Json& result : model.at("results"))
    if (result.at("method") == "copy of the arrays") copy = &result.at("seconds");
  bool begun = false;
  for (const Json& result : model.at("results")) {
    if (result.at("phase_seconds").empty()) continue;
    if (!begun) out << "| parts, ms | | × copy of the arrays |\n|---|---|--:|\n";
    begun = true;
    out << "| " << text(result.at("name")) << " | ";
    const char* separator = "";
    for (const auto& [name, times] : result.at("phase_seconds").items()) {
      out << separator << name << " " << median_milliseconds(times);
      separator = ", ";
    }
    const double floor = copy && !copy->is_null() ? (*copy).at("median").get<double>() : 0;
    out << " | " << (floor > 0 ? short_number(result.at("seconds").at("median").get<double>() / floor) : "")
        << " |\n";
  }
  if (begun) out << "\n";
}

}  // namespace

std::string markdown(const std::vector<Json>& runs) {
  std::ostringstream out;
  out << "# Speed of decimation\n\n";
  for (const Json& run : runs) write_run(out, run);
  out << "\n";
  write_figures(out, runs);
  for (const Json& run : runs)
    for (const Json& suite : run.at("suites")) {
      if (suite.at("suite") == "textured") {
        write_textured(out, suite);
        continue;
      }
      write_means(out, suite);
      for (const Json& model : suite.at("models")) {
        write_model(out, run, suite, model);
        write_topology(out, model);
        write_phases(out, model);
      }
    }
  return out.str();
}

}  // namespace whittle::speed
