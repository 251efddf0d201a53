/// \file
/// Every mesh of a folder through every module with two thresholds, and all guarantees checked; meshes that
/// are not manifold also after repair.
///   whittle_corpus FOLDER  prints a table as Markdown; exit code 1 if a guarantee does not hold
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "Guarantees.hh"
#include "files/MeshFile.hh"
#include "measure/MeshFacts.hh"
#include "recipe/Recipe.hh"

namespace {

namespace fs = std::filesystem;
using namespace whittle;

struct Case {
  const char* module;
  double ratio;  ///< 0: no target
};

constexpr Case kCases[] = {{"vt", 0},
                           {"vt:passes=3", 0},
                           {"fad:angle=10", 0},
                           {"fad:angle=60,boundary=merge", 0},
                           {"ivdd:distance=0.7e", 0},
                           {"ivdd:distance=1.2e,boundary=merge", 0},
                           {"ss:radius=0.8e", 0},
                           {"ss:radius=1.2e,placement=quadric,order=error", 0},
                           {"vtd:distance=0.8e", 0},
                           {"vtd:distance=1.2e", 0},
                           {"fass:radius=0.8e,angle=30", 0},
                           {"fass:radius=1.2e,angle=90", 0},
                           {"mq", 0.5},
                           {"mq", 0.1},
                           {"quadric", 0.5},
                           {"quadric", 0.1}};

struct Tally {
  std::size_t meshes = 0, runs = 0, failures = 0;
};

/// The violations of one way to run one mesh; empty if all holds.
std::string failure(const Case& c, const files::MeshFile& in, const corpus::Counted& before,
                    const corpus::Counted& taken, std::size_t& least) {
  recipe::Recipe recipe;
  recipe.modules = {recipe::parse_spec(c.module)};
  if (c.ratio > 0) recipe.target.ratio = c.ratio;
  try {
    const auto result = recipe::run(in.mesh, recipe, {}, {{}, {}, &in.attributes});
    least = std::min(least, result.mesh.triangles.size());
    const std::string what = corpus::broken(before, taken, recipe, result);
    const bool is_thin = measure::facts(result.mesh).degenerate_faces > before.facts.degenerate_faces;
    return what.empty() && is_thin ? "faces without area" : what;
  } catch (const std::exception& error) {
    return error.what();
  }
}

void run_cases(const std::string& name, const files::MeshFile& in, Tally& tally) {
  const corpus::Counted before(in.mesh), taken(corpus::as_openmesh_takes_it(in.mesh));
  std::string failed;
  std::size_t least = in.mesh.triangles.size();
  for (const Case& c : kCases) {
    ++tally.runs;
    const std::string what = failure(c, in, before, taken, least);
    if (what.empty()) continue;
    ++tally.failures;
    failed += (failed.empty() ? "" : "; ") + std::string(c.module) +
              (c.ratio > 0 ? " to " + std::to_string(c.ratio).substr(0, 3) : "") + ": " + what;
  }
  ++tally.meshes;
  std::printf("| %s | %zu | %zu | %zu | %zu | %zu | %s |\n", name.c_str(), in.mesh.triangles.size(),
              before.facts.nonmanifold_edges + before.facts.nonmanifold_vertices, before.facts.boundary_loops,
              in.mesh.triangles.size() - taken.mesh.triangles.size(), least,
              failed.empty() ? "all hold" : failed.c_str());
  std::fflush(stdout);
}

/// The mesh as it is, and where it is not manifold also repaired.
void run_mesh(const fs::path& path, const files::MeshFile& in, Tally& tally) {
  const std::string name = path.filename().string();
  run_cases(name, in, tally);
  const measure::MeshFacts facts = measure::facts(in.mesh);
  if (facts.nonmanifold_edges + facts.nonmanifold_vertices == 0) return;
  run_cases(name + ", repaired", files::read_mesh(path, {files::Repair::fix}), tally);
}

std::vector<fs::path> meshes_in(const fs::path& folder) {
  std::vector<fs::path> out;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    for (const char* known : {".off", ".ply", ".obj", ".stl"})
      if (extension == known) out.push_back(entry.path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: whittle_corpus FOLDER\n");
    return 2;
  }
  Tally tally;
  std::size_t clouds = 0;
  std::vector<std::string> refused;
  std::printf(
      "| mesh | faces | non-manifold places | boundary loops | not taken by OpenMesh | least faces left | "
      "guarantees |\n|---|--:|--:|--:|--:|--:|---|\n");
  for (const fs::path& path : meshes_in(argv[1])) {
    try {
      const auto in = files::read_mesh(path);
      if (in.mesh.triangles.empty())
        ++clouds;
      else
        run_mesh(path, in, tally);
    } catch (const files::FileError& error) {
      refused.push_back(fs::path(error.what()).filename().string());
    }
  }
  std::printf("\n%zu meshes, %zu runs, %zu failures; %zu files without a face, %zu refused by the reader%s\n",
              tally.meshes, tally.runs, tally.failures, clouds, refused.size(),
              refused.empty() ? "." : ":\n");
  for (const std::string& line : refused) std::printf("- `%s`\n", line.c_str());
  return tally.failures == 0 && tally.runs > 0 ? 0 : 1;
}
