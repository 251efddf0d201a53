#include "speed/markdown.hh"

#include <cmath>
#include <cstdio>
#include <sstream>

#include "speed/figures.hh"

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
  return text(run["openmesh_core"]["label"]);
}

void write_run(std::ostream& out, const Json& run) {
  const Json& build = run["build"];
  out << "- OpenMesh's core **" << core_of(run) << "**, " << text(run["date_utc"]) << ": "
      << text(run["machine"]["cpu_model"]) << ", " << run["settings"]["threads"] << " threads, "
      << number(run["machine"]["memory_bytes"].get<double>() / (1u << 30), 0) << " GiB; "
      << text(build["compiler"]) << ", `" << text(build["flags"]) << "`; commit " << text(build["git_commit"])
      << (build["git_dirty"] == true ? " with changes" : "");
  for (const auto& [name, version] : run["libraries"].items()) out << "; " << name << " " << text(version);
  if (!run["settings"]["only"].is_null()) out << "; only `" << text(run["settings"]["only"]) << "`";
  out << "\n";
  for (const Json& suite : run["suites"]) {
    out << "  - " << text(suite["suite"]) << ", " << suite["rounds"] << " rounds:";
    const char* separator = " ";
    for (const Json& model : suite["models"]) {
      out << separator << text(model["name"]) << " (" << model["vertices"] << " vertices, " << model["faces"]
          << " triangles, checksum " << text(model["checksum"]) << ")";
      separator = ", ";
    }
    out << "\n";
  }
}

void write_figures(std::ostream& out, const std::vector<Json>& runs) {
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

/// "1.23 (1.20..1.31)" in milliseconds: the median and the quartiles.
std::string milliseconds(const Json& times) {
  if (times.is_null()) return "";
  const auto ms = [&](const char* key) { return short_number(1000 * times[key].get<double>()); };
  return ms("median") + " (" + ms("lower_quartile") + ".." + ms("upper_quartile") + ")";
}

std::string median_milliseconds(const Json& times) {
  return times.is_null() ? "" : short_number(1000 * times["median"].get<double>());
}

void write_score(std::ostream& out, const Json& score) {
  if (score.is_null()) {
    out << " | | | | | |";
    return;
  }
  out << " " << score["faces"] << " |";
  const Json& distance = score["distance"];
  if (distance.is_null())
    out << " | | | |";
  else
    out << " " << number(distance["rms_percent_of_diagonal"], 4) << " | "
        << number(distance["mean_percent_of_diagonal"], 4) << " | "
        << number(distance["max_percent_of_diagonal"], 3) << " | " << distance["flipped_faces"] << " |";
  out << " " << score["nonmanifold_edges"] << " |";
}

void write_model(std::ostream& out, const Json& run, const Json& suite, const Json& model) {
  out << "## " << text(model["name"]) << ", " << text(suite["suite"]) << ", core " << core_of(run) << "\n\n"
      << model["faces"] << " triangles";
  if (model["faces_refused_by_openmesh"] != 0)
    out << ", of which OpenMesh does not take " << model["faces_refused_by_openmesh"];
  out << ". Times in milliseconds, median (quartiles); distances in percent of the diagonal, two-sided.\n\n"
      << "| contender | decimation, ms | load | unload | faces | RMS | mean | max | flipped | non-manifold "
         "edges "
         "| peak / loaded memory |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const Json& result : model["results"]) {
    out << "| " << text(result["name"]) << " | " << milliseconds(result["seconds"]) << " | "
        << median_milliseconds(result["load_seconds"]) << " | "
        << median_milliseconds(result["unload_seconds"]) << " |";
    write_score(out, result["score"]);
    const Json& memory = result["memory"];
    const double loaded = memory.is_null() ? 0 : memory["loaded_bytes"].get<double>();
    out << " " << (loaded > 0 ? short_number(memory["peak_bytes"].get<double>() / loaded) : "") << " |\n";
  }
  out << "\n";
}

/// Where the time of the contenders goes that tell it.
void write_phases(std::ostream& out, const Json& model) {
  const Json* copy = nullptr;
  for (const Json& result : model["results"])
    if (result["method"] == "copy of the arrays") copy = &result["seconds"];
  bool begun = false;
  for (const Json& result : model["results"]) {
    if (result["phase_seconds"].empty()) continue;
    if (!begun) out << "| parts, ms | | × copy of the arrays |\n|---|---|--:|\n";
    begun = true;
    out << "| " << text(result["name"]) << " | ";
    const char* separator = "";
    for (const auto& [name, times] : result["phase_seconds"].items()) {
      out << separator << name << " " << median_milliseconds(times);
      separator = ", ";
    }
    const double floor = copy && !copy->is_null() ? (*copy)["median"].get<double>() : 0;
    out << " | " << (floor > 0 ? short_number(result["seconds"]["median"].get<double>() / floor) : "")
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
    for (const Json& suite : run["suites"])
      for (const Json& model : suite["models"]) {
        write_model(out, run, suite, model);
        write_phases(out, model);
      }
  return out.str();
}

}  // namespace whittle::speed
