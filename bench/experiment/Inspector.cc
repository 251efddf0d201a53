#include "experiment/Inspector.hh"

#include <algorithm>
#include <cmath>

#include "fidelity/ImageDifference.hh"
#include "fidelity/NormalDeviation.hh"
#include "files/MeshFile.hh"
#include "measure/Distance.hh"
#include "measure/MeshFacts.hh"
#include "peers/vertex_cache.hh"
#include "render/Framebuffer.hh"

namespace whittle::bench {
namespace {

constexpr int kSamplesPerPixel = 4;
constexpr int kViewSide = 256;      // of the compared views
constexpr int kPictureSide = 360;   // the longer one
constexpr int kOriginalSide = 720;  // the original is shown larger
constexpr char kFolder[] = "pictures";

struct Size {
  int width, height;
};

Size fit(const Settings& settings, int side) {
  const int longer = std::max(settings.width, settings.height);
  return {std::max(1, side * settings.width / longer), std::max(1, side * settings.height / longer)};
}

}  // namespace

Inspector::Inspector(const IndexedMesh& original, const Settings& settings, ExperimentResult& experiment,
                     const std::filesystem::path& folder)
    : original_(original),
      settings_(settings),
      experiment_(experiment),
      folder_(folder),
      around_(views_around(original, settings.views)),
      original_views_(draw_views(original)) {
  std::filesystem::create_directories(folder_ / kFolder);
}

std::vector<render::Image> Inspector::draw_views(const IndexedMesh& mesh) const {
  const render::Framebuffer framebuffer(kViewSide, kViewSide, kSamplesPerPixel);
  const render::MeshBuffers buffers(mesh);
  std::vector<render::Image> images;
  for (const auto& camera : around_) {
    renderer_.draw(buffers, camera);
    images.push_back(framebuffer.read());
  }
  return images;
}

Fidelity Inspector::fidelity(const IndexedMesh& mesh, std::size_t& flipped_faces) const {
  Fidelity f;
  measure::DistanceOptions options;
  options.samples = settings_.samples;
  const auto both = measure::distance(original_, mesh, options);
  const auto& distance = both.two_sided;
  flipped_faces = both.flipped_faces;
  f.rms = distance.rms;
  f.mean = distance.mean;
  f.max = distance.max;
  const NormalDeviation normals = normal_deviation(original_, mesh);
  f.normal_mean_degrees = normals.mean_degrees;
  f.normal_max_degrees = normals.max_degrees;
  const TriangleQuality quality = triangle_quality(mesh);
  f.quality_mean = quality.mean;
  f.quality_p05 = quality.p05;
  const ViewsDifference images = views_difference(original_views_, draw_views(mesh));
  f.psnr_db = images.psnr_db;
  f.psnr_worst_db = images.psnr_worst_db;
  f.ssim = images.ssim;
  f.ssim_worst = images.ssim_worst;
  return f;
}

std::string Inspector::write(const SetResult& set, const std::string& kind,
                             const render::Image& image) const {
  const std::string name =
      std::string(kFolder) + "/" + experiment_.name + "-" + set.definition.name + "-" + kind + ".png";
  const std::string caption =
      set.definition.label + ", " + experiment_.model.label + (kind == "whole" ? "" : ", " + kind);
  files::write_file(folder_ / name, render::encode_png(image, caption));
  return name;
}

void Inspector::take_pictures(SetResult& set, const IndexedMesh& mesh) const {
  const bool original = set.definition.original();
  const auto [width, height] = fit(settings_, original ? kOriginalSide : kPictureSide);
  const render::Framebuffer framebuffer(width, height, kSamplesPerPixel);
  const Views cameras = views(original_, static_cast<double>(settings_.width) / settings_.height);
  const render::MeshBuffers buffers(mesh);
  renderer_.draw(buffers, cameras.whole);
  set.pictures.whole = write(set, "whole", framebuffer.read());
  if (experiment_.name != "paper2") {
    renderer_.draw(buffers, cameras.ears);
    set.pictures.detail = write(set, "detail", framebuffer.read());
  }
  if (original) return;
  // The error is painted on the original, whose points lie densest.
  const auto distances = distances_to(original_, mesh);
  std::vector<float> heat;
  for (const double distance : distances)
    heat.push_back(static_cast<float>(distance / experiment_.heat_scale));
  heat_painter_.draw(render::MeshBuffers(original_, heat), cameras.whole);
  set.pictures.heat = write(set, "heat", framebuffer.read());
}

void Inspector::inspect(SetResult& set, const MadeSet& made) const {
  const measure::MeshFacts facts = measure::facts(made.mesh);
  set.vertices = facts.vertices;
  set.triangles = facts.faces;
  set.nonmanifold_edges = facts.nonmanifold_edges;
  set.flipped_faces = made.flipped_faces;
  set.decimation_ms = made.milliseconds;
  set.cache_misses_per_triangle = peers::cache_misses_per_triangle(made.mesh);
  if (made.mesh.triangles.empty()) {
    set.note = "nothing is left to draw";
  } else if (facts.degenerate_faces == facts.faces) {
    set.note = "only triangles without area are left";
  } else if (set.definition.role != Role::cache) {
    if (!set.fidelity && !set.definition.original()) {
      std::size_t flipped = 0;
      set.fidelity = fidelity(made.mesh, flipped);
      if (set.definition.role == Role::peer) set.flipped_faces = flipped;
    }
    if (set.definition.role != Role::curve) take_pictures(set, made.mesh);
  }
  set.made = true;
}

}  // namespace whittle::bench
