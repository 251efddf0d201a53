#include "experiment/Experiment.hh"

#include <algorithm>

#include "render/FrameTimer.hh"
#include "render/Framebuffer.hh"

namespace whittle::bench {

std::vector<std::size_t> visiting_order(std::size_t sets, std::size_t repetition) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < sets; ++i) order.push_back((repetition + i) % sets);
  return order;
}

std::vector<std::size_t> missing_visits(const ExperimentResult& experiment, std::size_t repetition) {
  const auto visited = [&](const SetResult& set) {
    return std::any_of(set.visits.begin(), set.visits.end(),
                       [&](const Visit& visit) { return visit.repetition == repetition; });
  };
  std::vector<std::size_t> missing;
  bool original_is_among = false;
  for (const std::size_t i : visiting_order(experiment.sets.size(), repetition - 1)) {
    const SetResult& set = experiment.sets[i];
    if (set.triangles == 0 || visited(set)) continue;
    missing.push_back(i);
    original_is_among |= i == 0;
  }
  if (!missing.empty() && !original_is_among) missing.insert(missing.begin(), 0);
  return missing;
}

void time_sets(const render::Renderer& renderer, const render::Camera& camera, const Settings& settings,
               const std::vector<const IndexedMesh*>& meshes, std::size_t start, ExperimentResult& experiment,
               const Watch& watch) {
  const render::Framebuffer framebuffer(settings.width, settings.height);
  std::vector<render::MeshBuffers> buffers;
  buffers.reserve(meshes.size());
  for (const IndexedMesh* mesh : meshes) buffers.emplace_back(*mesh);
  framebuffer.bind();

  const Timing& timing = experiment.timing;
  std::size_t steps = 0;
  for (std::size_t repetition = 1; repetition <= timing.repetitions; ++repetition)
    steps += missing_visits(experiment, repetition).size();
  watch.progress.expect(steps);
  for (std::size_t repetition = 1; repetition <= timing.repetitions; ++repetition) {
    std::size_t place = 0;
    for (const std::size_t i : missing_visits(experiment, repetition)) {
      SetResult& set = experiment.sets[i];
      watch.progress.step(experiment.name + ", repetition " + std::to_string(repetition) + " of " +
                          std::to_string(timing.repetitions) + ", " + set.definition.name);
      const auto draw = [&] {
        if (watch.stop()) throw Stopped();
        renderer.draw(buffers[i], camera);
      };
      const auto time = render::time_frames(draw, {timing.frames_from, timing.frames_to});
      set.visits.push_back({repetition, start, ++place, time.wall_ms, time.gl_ms});
      watch.visited();
    }
  }
}

}  // namespace whittle::bench
