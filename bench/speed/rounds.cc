#include "speed/rounds.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <utility>

#include "measure/smooth_limit.hh"
#include "peers/precision.hh"
#include "recipe/Stopwatch.hh"
#include "speed/memory.hh"

namespace whittle::speed {
namespace {

bool is_large(const Subject& subject) {
  return subject.n_faces() > kLargeFaces;
}

/// An untimed run: memory is counted, and the result scored.
void rehearse(const Subject& subject, Scorer& scorer, Result& result) {
  const auto contender = result.entry.make();
  Phases phases;
  if (!result.entry.countable || (result.entry.heavy && is_large(subject))) {
    contender->load(subject);
    contender->decimate(phases);
  } else {
    MemoryCount count;
    contender->load(subject);
    const std::int64_t in_place =
        result.entry.in_place ? static_cast<std::int64_t>(subject.array_bytes()) : 0;
    Memory memory;
    memory.loaded = in_place + count.live();
    count.restart_peak();
    contender->decimate(phases);
    memory.peak = in_place + count.peak();
    result.memory = memory;
  }
  const Arrays mesh = contender->unload();
  if (!mesh.triangles.empty()) result.score = scorer.score(mesh);
}

void note_phases(const Phases& phases, Result& result) {
  if (result.phase_seconds.empty())
    for (const auto& phase : phases) result.phase_seconds.push_back({phase.first, {}});
  for (std::size_t i = 0; i < phases.size(); ++i) result.phase_seconds[i].second.push_back(phases[i].second);
}

void time(const Subject& subject, Result& result) {
  const auto contender = result.entry.make();
  Phases phases;
  recipe::Stopwatch watch;
  contender->load(subject);
  result.load_seconds.push_back(watch.lap());
  contender->decimate(phases);
  result.seconds.push_back(watch.lap());
  contender->unload();
  result.unload_seconds.push_back(watch.lap());
  note_phases(phases, result);
}

using Visit = std::pair<const Subject*, Result*>;

/// A new order in which those who do the same, the same model to the same target, stay together: whatever
/// else the machine does meanwhile affects them alike.
void shuffle(std::vector<Visit>& visits, std::mt19937& random) {
  std::shuffle(visits.begin(), visits.end(), random);
  const auto task = [](const Visit& visit) {
    return std::make_pair(visit.first, visit.second->entry.target);
  };
  std::map<std::pair<const Subject*, std::string>, std::size_t> places;
  for (const Visit& visit : visits) places.emplace(task(visit), places.size());
  std::stable_sort(visits.begin(), visits.end(),
                   [&](const Visit& a, const Visit& b) { return places.at(task(a)) < places.at(task(b)); });
}

}  // namespace

std::vector<ModelResults> run_rounds(const Settings& settings, const std::vector<Subject>& subjects,
                                     terminal::Progress& progress) {
  const std::size_t rounds = settings.rounds;
  std::vector<ModelResults> models;
  std::vector<Visit> visits;
  for (const Subject& subject : subjects) {
    progress.say(subject.name + ": planning");
    ModelResults& model = models.emplace_back();
    model.subject = &subject;
    const IndexedMesh mesh = peers::in_double(subject.arrays);
    Eigen::AlignedBox3d box;
    for (const auto& p : mesh.points) box.extend(p);
    if (const double diagonal = box.diagonal().norm(); diagonal > 0)
      model.smooth_limit = 100 * measure::smooth_limit(mesh) / diagonal;
    for (Entry& entry : lineup(settings.suite, subject, settings.only))
      model.results.emplace_back().entry = std::move(entry);
  }
  for (ModelResults& model : models)
    for (Result& result : model.results) visits.emplace_back(model.subject, &result);

  progress.expect(visits.size() * (rounds + 1));
  for (ModelResults& model : models) {
    Scorer scorer(*model.subject, settings.suite == Suite::growth ? 0 : settings.samples,
                  settings.suite == Suite::truth);
    if (settings.suite == Suite::truth) model.input = scorer.score(model.subject->arrays);
    for (Result& result : model.results) {
      progress.step("scoring, " + model.subject->name + ", " + result.entry.name());
      rehearse(*model.subject, scorer, result);
    }
  }
  std::mt19937 random(1);
  for (std::size_t round = 0; round < rounds; ++round) {
    shuffle(visits, random);
    for (const auto& [subject, result] : visits) {
      progress.step("round " + std::to_string(round + 1) + " of " + std::to_string(rounds) + ", " +
                    subject->name + ", " + result->entry.name());
      if (result->entry.heavy && is_large(*subject) && round >= kHeavyRounds) continue;
      time(*subject, *result);
    }
  }
  return models;
}

}  // namespace whittle::speed
