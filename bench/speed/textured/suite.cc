#include "speed/textured/suite.hh"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "files/MeshFile.hh"
#include "recipe/Recipe.hh"
#include "recipe/Stopwatch.hh"
#include "results/Statistics.hh"
#include "speed/textured/Pictures.hh"
#include "speed/textured/Worth.hh"
#include "whittle/surface/charts.hh"
#include "whittle/surface/errors.hh"

namespace whittle::speed {
namespace {

constexpr std::array<int, 5> kPercents = {50, 25, 10, 5, 2};
constexpr int kPicturePercent = 10;

/// What of a model counts in a run.
enum class Counts { nothing, seams, values };
constexpr std::array<std::pair<Counts, const char*>, 3> kCounts = {
    {{Counts::nothing, "nothing"}, {Counts::seams, "seams"}, {Counts::values, "values"}}};

bool has_texture(const TexturedModel& model) {
  return std::any_of(model.attributes.begin(), model.attributes.end(),
                     [](const auto& a) { return a.kind == attributes::Kind::texture; });
}

recipe::Result decimate(const TexturedModel& model, int percent, Counts counts) {
  recipe::Recipe recipe;
  std::string spec = "mq";
  if (counts == Counts::seams) {
    std::string keys;
    for (const auto& attribute : model.attributes)
      keys += (keys.empty() ? ":" : ",") +
              std::string(attribute.kind == attributes::Kind::texture ? "texture=0" : "colours=0");
    spec += keys;
  }
  recipe.modules = {recipe::parse_spec(spec)};
  recipe.target.ratio = percent / 100.0;
  recipe::Givens givens;
  if (counts != Counts::nothing) givens.attributes = &model.attributes;
  return recipe::run(model.mesh, recipe, {}, givens);
}

Json pair_json(double rms, double max) {
  return {{"rms", rms}, {"max", max}};
}

Json worth_json(const Worth& worth, const Worth& input) {
  Json texture = nullptr, colours = nullptr;
  if (worth.texture) {
    texture = pair_json(worth.texture->rms, worth.texture->max);
    texture["charts"] = worth.texture->charts;
    texture["charts_left"] = worth.texture->charts_left;
  }
  if (worth.colours) colours = pair_json(worth.colours->rms, worth.colours->max);
  return {{"faces", worth.faces},
          {"rms_ten_thousandths_of_diagonal", worth.rms},
          {"texture_texels_of_1024", texture},
          {"colours_255ths", colours},
          {"topology_kept", worth.has_topology_of(input)}};
}

/// Decimation, and the whole run with seams and weights before and the transfer of values afterwards.
struct Times {
  std::vector<double> decimation, whole;
};

class TexturedRun {
 public:
  TexturedRun(const TexturedSettings& settings, terminal::Progress& progress)
      : settings_(settings), progress_(progress) {
    try {
      std::filesystem::create_directories(settings.pictures);
      pictures_.emplace(settings.pictures);
    } catch (const egl::EglError& error) {
      why_no_pictures_ = error.what();
    }
  }

  Json suite(const std::vector<TexturedModel>& models) {
    progress_.expect(models.size() * kPercents.size());
    Json list = Json::array();
    for (const TexturedModel& model : models) list.push_back(run(model));
    return {{"suite", "textured"},
            {"rounds", settings_.rounds},
            {"samples", settings_.samples},
            {"renderer", pictures_ ? Json(pictures_->renderer()) : Json(nullptr)},
            {"why_no_pictures", pictures_ ? Json(nullptr) : Json(why_no_pictures_)},
            {"models", list}};
  }

 private:
  Json run(const TexturedModel& model) {
    input_ = topology(model.mesh);
    Json picture = pictures_ ? Json(pictures_->begin(model)) : Json(nullptr);
    Json results = Json::array();
    for (const int percent : kPercents) {
      progress_.step(model.name + ", " + std::to_string(percent) + " %");
      results.push_back(ours(model, percent));
      if (settings_.peers) add_peers(model, percent, results);
    }
    return {{"name", model.name},
            {"half", to_string(model.half)},
            {"vertices", model.mesh.points.size()},
            {"faces", model.mesh.triangles.size()},
            {"picture", picture},
            {"results", results}};
  }

  Json ours(const TexturedModel& model, int percent) {
    const recipe::Result result = decimate(model, percent, Counts::values);
    const recipe::Result plain = decimate(model, percent, Counts::nothing);
    Json out = {{"percent", percent}, {"contender", "mq"}};
    out.update(worth_json(worth(model, result.mesh, result.attributes, settings_.samples), input_));
    out["rms_without_attributes"] = worth(model, plain.mesh, {}, settings_.samples).rms;
    add_looks(result.mesh, result.attributes, percent, "mq", out);
    out["seconds"] = times(model, percent);
    return out;
  }

  Json times(const TexturedModel& model, int percent) const {
    std::map<Counts, Times> times;
    for (std::size_t round = 0; round < settings_.rounds; ++round)
      for (std::size_t i = 0; i < kCounts.size(); ++i) {
        const Counts counts = kCounts[(i + round) % kCounts.size()].first;
        if (counts == Counts::seams && !has_texture(model)) continue;
        recipe::Stopwatch watch;
        const recipe::Result result = decimate(model, percent, counts);
        times[counts].whole.push_back(watch.lap());
        times[counts].decimation.push_back(result.seconds());
      }
    Json out = Json::object();
    for (const auto& [counts, name] : kCounts) {
      const auto found = times.find(counts);
      if (found == times.end()) continue;
      out[name] = {{"decimation", bench::quantile(found->second.decimation, 0.5)},
                   {"whole", bench::quantile(found->second.whole, 0.5)}};
    }
    return out;
  }

  void add_looks(const IndexedMesh& mesh, const attributes::Attributes& attributes, int percent,
                 const std::string& contender, Json& out) const {
    out["psnr_db"] = pictures_ ? Json(pictures_->psnr(mesh, attributes)) : Json(nullptr);
    const bool is_shown = pictures_ && percent == kPicturePercent;
    out["picture"] = is_shown
                         ? Json(pictures_->write(mesh, attributes, std::to_string(percent) + "-" + contender))
                         : Json(nullptr);
  }

  /// What each folder of the peers' has of a model.
  void add_peers(const TexturedModel& model, int percent, Json& results) const {
    namespace fs = std::filesystem;
    std::vector<fs::path> found;
    const std::string stem = model.name + "-" + std::to_string(percent);
    for (const auto& peer : fs::directory_iterator(*settings_.peers)) {
      if (!peer.is_directory()) continue;
      for (const auto& file : fs::directory_iterator(peer))
        if (file.path().stem() == stem) found.push_back(file.path());
    }
    std::sort(found.begin(), found.end());
    for (const fs::path& path : found) {
      const std::string name = path.parent_path().filename().string();
      Json out = {{"percent", percent}, {"contender", name}};
      const files::MeshFile file = files::read_mesh(path);
      try {
        out.update(worth_json(worth(model, file.mesh, file.attributes, settings_.samples), input_));
      } catch (const InvalidMesh&) {
        continue;  // nothing is left of it
      }
      add_looks(file.mesh, file.attributes, percent, name, out);
      results.push_back(out);
    }
  }

  const TexturedSettings& settings_;
  terminal::Progress& progress_;
  std::optional<Pictures> pictures_;
  std::string why_no_pictures_;
  Worth input_;
};

}  // namespace

Json run_textured(const std::vector<TexturedModel>& models, const TexturedSettings& settings,
                  terminal::Progress& progress) {
  return TexturedRun(settings, progress).suite(models);
}

void export_textured(const std::vector<TexturedModel>& models, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const TexturedModel& model : models)
    files::write_mesh(folder / (model.name + ".glb"), model.mesh, {}, model.attributes);
}

}  // namespace whittle::speed
