#include "experiment/Experiment.hh"

#include "recipe/Recipe.hh"
#include "render/Framebuffer.hh"

namespace whittle::bench {
namespace {

constexpr int kPictureSamples = 4;

/// Of the box's width, height and depth.
const Eigen::AlignedBox3d kEars(Eigen::Vector3d(0.06, 0.74, 0.1), Eigen::Vector3d(0.56, 1.0, 0.75));

}  // namespace

SetResult decimate(const IndexedMesh& original, const SetDefinition& definition) {
  SetResult set;
  set.definition = definition;
  if (definition.recipe.empty()) {
    set.mesh = original;
  } else {
    recipe::Recipe recipe;
    recipe.modules = {recipe::parse_spec(definition.recipe)};
    auto result = recipe::run(original, recipe);
    set.mesh = std::move(result.mesh);
    set.flipped_faces = result.flipped_faces;
  }
  set.facts = measure::facts(set.mesh);
  return set;
}

Views views(const IndexedMesh& original, double aspect) {
  const auto box = render::bounding_box(original);
  return {render::frame(box, box, aspect), render::frame(render::part_of(box, kEars), box, aspect)};
}

Pictures take_pictures(const render::Renderer& renderer, const Views& views, const IndexedMesh& mesh,
                       int width, int height) {
  const render::Framebuffer framebuffer(width, height, kPictureSamples);
  const render::MeshBuffers buffers(mesh);
  const auto picture = [&](const render::Camera& camera) {
    renderer.draw(buffers, camera);
    return framebuffer.read();
  };
  return {picture(views.whole), picture(views.ears)};
}

std::vector<std::size_t> visiting_order(std::size_t sets, std::size_t repetition) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < sets; ++i) order.push_back((repetition + i) % sets);
  return order;
}

void time_sets(const render::Renderer& renderer, const render::Camera& camera, const Settings& settings,
               std::vector<SetResult>& sets, Progress& progress, const std::function<bool()>& stop) {
  const render::Framebuffer framebuffer(settings.width, settings.height);
  std::vector<render::MeshBuffers> buffers;
  buffers.reserve(sets.size());
  for (const auto& set : sets) buffers.emplace_back(set.mesh);

  progress.expect(settings.repetitions * sets.size());
  for (std::size_t repetition = 0; repetition < settings.repetitions; ++repetition) {
    std::size_t place = 0;
    for (const std::size_t i : visiting_order(sets.size(), repetition)) {
      progress.step("repetition " + std::to_string(repetition + 1) + " of " +
                    std::to_string(settings.repetitions) + ", " + sets[i].definition.paper_label);
      const auto draw = [&] {
        if (stop()) throw Stopped();
        renderer.draw(buffers[i], camera);
      };
      sets[i].visits.push_back({++place, render::time_frames(draw, settings.frames)});
    }
  }
}

}  // namespace whittle::bench
