#include "experiment/Model.hh"

#include <cstdio>
#include <stdexcept>

#include "experiment/GeneratedMesh.hh"
#include "files/MeshFile.hh"
#include "measure/MeshFacts.hh"
#include "render/MeshBuffers.hh"

namespace whittle::bench {
namespace {

std::optional<std::filesystem::path> cached(const std::filesystem::path& cache, const std::string& name) {
  for (const char* extension : {".ply", ".obj", ".off", ".stl"}) {
    if (std::filesystem::is_regular_file(cache / (name + extension))) return cache / (name + extension);
  }
  return std::nullopt;
}

Model read(const std::filesystem::path& path, ModelKind kind) {
  auto file = files::read_mesh(path);
  if (file.mesh.triangles.empty())
    throw std::invalid_argument(path.string() + ": there is no triangle to draw");
  if (const auto facts = measure::facts(file.mesh); facts.degenerate_faces == facts.faces)
    throw std::invalid_argument(path.string() + ": no triangle has an area");
  Model model;
  model.mesh = std::move(file.mesh);
  model.kind = kind;
  model.file = path.filename().string();
  model.label = kind == ModelKind::bunny ? "Stanford bunny" : model.file;
  model.notes = file.report.notes();
  return model;
}

Model generate() {
  Model model;
  model.mesh = generated_mesh();
  model.label = kGeneratedLabel;
  model.notes = {std::string("the bunny is not there (assets/fetch.sh bunny gets it); this is a ") +
                 kGeneratedLabel};
  return model;
}

/// The paper's lengths are absolute, so they only suit a model in the bunny's units and of its density.
std::optional<std::string> unit_note(double mean_edge) {
  if (mean_edge > kBunnyMeanEdge / 2 && mean_edge < kBunnyMeanEdge * 2) return std::nullopt;
  char text[200];
  std::snprintf(text, sizeof text,
                "the distances of the sets are in the units of Stanford's bunny (mean edge %g), but the mean "
                "edge of this "
                "model is %.3g: they remove more or less than in the paper",
                kBunnyMeanEdge, mean_edge);
  return text;
}

}  // namespace

std::string to_string(ModelKind kind) {
  switch (kind) {
    case ModelKind::bunny:
      return "bunny";
    case ModelKind::file:
      return "file";
    case ModelKind::generated:
      return "generated";
  }
  return "unknown";
}

Model load_model(const std::optional<std::filesystem::path>& file, const std::filesystem::path& cache,
                 const std::string& label) {
  const auto bunny = file ? std::nullopt : cached(cache, "bunny");
  Model model = file ? read(*file, ModelKind::file) : bunny ? read(*bunny, ModelKind::bunny) : generate();
  model.mean_edge = mean_edge_length(model.mesh);
  if (const auto note = unit_note(model.mean_edge)) model.notes.push_back(*note);
  if (!label.empty())
    model.label = model.kind == ModelKind::generated ? label + " (" + kGeneratedLabel + ")" : label;
  return model;
}

std::optional<Model> load_monkey(const std::optional<std::filesystem::path>& file,
                                 const std::filesystem::path& cache) {
  const auto path = file ? file : cached(cache, "suzanne");
  if (!path) return std::nullopt;
  Model model = read(*path, ModelKind::file);
  if (!file) model.label = "Suzanne";
  model.mean_edge = mean_edge_length(model.mesh);
  return model;
}

ModelFacts facts(const Model& model) {
  const double diagonal = model.mesh.points.empty() ? 0 : render::bounding_box(model.mesh).sizes().norm();
  return {model.label,
          to_string(model.kind),
          model.file,
          model.mesh.points.size(),
          model.mesh.triangles.size(),
          model.mean_edge,
          diagonal,
          model.notes};
}

}  // namespace whittle::bench
