/// \file
/// Every mesh of a folder through every module with two thresholds, and all guarantees checked.
///   whittle_corpus FOLDER  prints a table as Markdown; exit code 1 if a guarantee does not hold
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

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

/// What must be as it was; empty if it is.
std::string broken(const measure::MeshFacts& before, const measure::MeshFacts& after,
                   const recipe::Result& result) {
  std::string what;
  const auto check = [&](bool holds, const char* name) {
    if (!holds) what += (what.empty() ? "" : ", ") + std::string(name);
  };
  check(after.faces <= before.faces, "more faces");
  check(after.nonmanifold_edges <= before.nonmanifold_edges, "non-manifold edges");
  check(after.nonmanifold_vertices <= before.nonmanifold_vertices, "non-manifold vertices");
  check(result.flipped_faces == 0, "flipped faces");
  if (result.refused_faces == 0) {  // else a part of the mesh is left out, and that is said
    check(after.euler_characteristic - static_cast<long>(after.isolated_vertices) ==
              before.euler_characteristic - static_cast<long>(before.isolated_vertices),
          "Euler characteristic");
    check(after.boundary_loops == before.boundary_loops, "boundary loops");
    check(after.components - after.isolated_vertices == before.components - before.isolated_vertices,
          "components");
  }
  return what;
}

struct Tally {
  std::size_t runs = 0, failures = 0;
};

void run_cases(const fs::path& path, const files::MeshFile& in, Tally& tally) {
  const auto before = measure::facts(in.mesh);
  std::string failed;
  std::size_t least = in.mesh.triangles.size();
  for (const Case& c : kCases) {
    recipe::Recipe recipe;
    recipe.modules = {recipe::parse_spec(c.module)};
    if (c.ratio > 0) recipe.target.ratio = c.ratio;
    ++tally.runs;
    std::string what;
    try {
      const auto result = recipe::run(in.mesh, recipe, {}, {{}, {}, &in.attributes});
      least = std::min(least, result.mesh.triangles.size());
      what = broken(before, measure::facts(result.mesh), result);
    } catch (const std::exception& error) {
      what = error.what();
    }
    if (what.empty()) continue;
    ++tally.failures;
    failed += (failed.empty() ? "" : "; ") + std::string(c.module) + ": " + what;
  }
  std::printf("| %s | %zu | %zu | %zu | %zu | %s |\n", path.filename().c_str(), in.mesh.triangles.size(),
              before.nonmanifold_edges + before.nonmanifold_vertices, before.boundary_loops, least,
              failed.empty() ? "all hold" : failed.c_str());
  std::fflush(stdout);
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
  std::size_t read = 0;
  std::vector<std::string> refused;
  std::printf("| mesh | faces | non-manifold places | boundary loops | least faces left | guarantees |\n");
  std::printf("|---|--:|--:|--:|--:|---|\n");
  for (const fs::path& path : meshes_in(argv[1])) {
    try {
      const auto in = files::read_mesh(path);
      if (in.mesh.triangles.empty()) throw files::FileError(path.string() + ": has no faces");
      run_cases(path, in, tally);
      ++read;
    } catch (const files::FileError& error) {
      refused.push_back(fs::path(error.what()).filename().string());
    }
  }
  std::printf("\n%zu meshes, %zu runs, %zu failures. Refused by the reader, %zu:\n\n", read, tally.runs,
              tally.failures, refused.size());
  for (const std::string& line : refused) std::printf("- `%s`\n", line.c_str());
  return tally.failures == 0 ? 0 : 1;
}
