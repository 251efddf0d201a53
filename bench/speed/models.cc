#include "speed/models.hh"

#include <stdexcept>
#include <utility>

#include "files/MeshFile.hh"
#include "peers/precision.hh"
#include "speed/subdivide.hh"

namespace whittle::speed {

std::vector<Subject> load_models(std::vector<std::filesystem::path> files, const std::filesystem::path& cache,
                                 Suite suite, std::size_t subdivisions) {
  if (files.empty()) {
    files.push_back(cache / "bunny.obj");
    if (!std::filesystem::exists(files.front()))
      throw std::runtime_error("the bunny is not there; assets/fetch.sh gets it, or name a model");
    const auto dragon = cache / "dragon.ply";
    if (std::filesystem::exists(dragon)) files.push_back(dragon);
  }
  std::vector<Subject> subjects;
  for (const auto& file : files) {
    const auto read = files::read_mesh(file);
    if (read.mesh.triangles.empty()) throw std::runtime_error(file.string() + ": there is no triangle");
    Arrays arrays = peers::in_float(read.mesh);
    for (const auto& p : arrays.points)
      if (!p.allFinite())
        throw std::runtime_error(file.string() + ": a coordinate is too large for single precision");
    subjects.push_back(make_subject(file.stem().string(), std::move(arrays)));
  }
  if (suite == Suite::growth) {
    std::string name = subjects.back().name;
    for (std::size_t i = 0; i < subdivisions; ++i) {
      name += " x4";
      subjects.push_back(make_subject(name, subdivide(subjects.back().arrays)));
    }
  }
  return subjects;
}

}  // namespace whittle::speed
