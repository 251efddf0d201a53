#include "experiment/Store.hh"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "files/MeshFile.hh"
#include "results/json.hh"

namespace whittle::bench {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file || file.bad() || fs::is_directory(path))
    throw std::runtime_error(path.string() + ": " +
                             std::strerror(fs::is_directory(path) ? EISDIR
                                           : errno                ? errno
                                                                  : EIO));
  return text;
}

Store::Store(const fs::path& folder) : folder_(folder) {
  fs::create_directories(folder_);
  files::check_creatable(path());
}

std::optional<Results> Store::load() const {
  if (!fs::exists(path())) return std::nullopt;
  try {
    return parse_results(read_text(path()));
  } catch (const ResultsError& error) {
    throw ResultsError(path().string() + ": " + error.what());
  }
}

std::optional<fs::path> Store::set_aside() const {
  if (!fs::exists(path())) return std::nullopt;
  for (int i = 1;; ++i) {
    const fs::path other = folder_ / ("results." + std::to_string(i) + ".json");
    if (fs::exists(other)) continue;
    fs::rename(path(), other);
    return other;
  }
}

void Store::save(const Results& results) const {
  try {
    files::write_file(path(), json_text(results));
  } catch (const files::FileError& error) {
    throw SaveError(
        std::string(error.what()) +
        (fs::exists(path()) ? "; what was saved before is whole, and --resume goes on from there" : ""));
  }
}

std::string difference(const Results& earlier, const Results& wanted) {
  const auto differs = [](const std::string& what, const auto& a, const auto& b) {
    return what + " was " + a + " and is now " + b;
  };
  const auto size = [](const Results& r) {
    return std::to_string(r.settings.width) + "x" + std::to_string(r.settings.height);
  };
  if (earlier.protocol != wanted.protocol) return differs("the protocol", earlier.protocol, wanted.protocol);
  if (size(earlier) != size(wanted)) return differs("the image size", size(earlier), size(wanted));
  if (earlier.settings.views != wanted.settings.views || earlier.settings.samples != wanted.settings.samples)
    return "the number of views or samples was another";
  const Environment &a = earlier.environment, &b = wanted.environment;
  if (a.gl_renderer != b.gl_renderer) return differs("the renderer", a.gl_renderer, b.gl_renderer);
  if (a.cpu_model != b.cpu_model) return differs("the processor", a.cpu_model, b.cpu_model);
  if (a.commit != b.commit) return differs("the commit", a.commit, b.commit);
  if (earlier.experiments.size() != wanted.experiments.size()) return "the experiments were others";
  for (std::size_t i = 0; i < wanted.experiments.size(); ++i) {
    const ExperimentResult &x = earlier.experiments[i], &y = wanted.experiments[i];
    const std::string in = "in " + y.name + " ";
    if (x.name != y.name) return "the experiments were others";
    if (x.model.vertices != y.model.vertices || x.model.triangles != y.model.triangles ||
        x.model.label != y.model.label || x.model.mean_edge != y.model.mean_edge)
      return in + "the model was another";
    if (x.timing.frames_from != y.timing.frames_from || x.timing.frames_to != y.timing.frames_to ||
        x.timing.repetitions != y.timing.repetitions)
      return in + "the frames or repetitions were others";
    if (x.sets.size() != y.sets.size()) return in + "the sets were others";
    for (std::size_t s = 0; s < y.sets.size(); ++s)
      if (x.sets[s].definition.name != y.sets[s].definition.name ||
          x.sets[s].definition.recipe != y.sets[s].definition.recipe)
        return in + "the sets were others";
  }
  return "";
}

}  // namespace whittle::bench
