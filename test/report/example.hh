/// \file
/// Results made up by hand, with round numbers.
#pragma once

#include <string>
#include <vector>

#include "results/Results.hh"

namespace example {

using namespace whittle::bench;

/// A set of so many triangles with a time for each repetition; GL timers run a tenth shorter.
inline SetResult timed(SetDefinition definition, std::size_t triangles, const std::vector<double>& wall_ms) {
  SetResult set;
  set.definition = std::move(definition);
  set.vertices = triangles / 2;
  set.triangles = triangles;
  set.made = true;
  for (std::size_t i = 0; i < wall_ms.size(); ++i)
    set.visits.push_back({i + 1, 1, 1, wall_ms[i], 0.9 * wall_ms[i]});
  return set;
}

inline SetDefinition original() {
  return {"original", "Original", "", "", "", "", Role::paper};
}

/// Paper 1 with VT, FAD at both angles and one IVDD; a hundred frames timed, two repetitions.
inline ExperimentResult paper1() {
  ExperimentResult e;
  e.name = "paper1";
  e.model = {"a <small> bunny", "file", "b.obj", 500, 1000, 0.5, 10, {"a note | with a bar"}};
  e.timing = {100, 200, 2};
  e.heat_scale = 0.05;
  e.sets = {timed(original(), 1000, {100, 200}),
            timed({"vt", "VT", "VT", "", "vt", "", Role::paper}, 400, {50, 100}),
            timed({"fad-30", "FAD 30", "FAD", "30°", "fad:angle=30", "", Role::paper}, 750, {80, 160}),
            timed({"fad-150", "FAD 150", "FAD", "150°", "fad:angle=150", "", Role::paper}, 740, {80, 160}),
            timed({"ivdd-0.0011", "IVDD", "IVDD", ".0011", "ivdd:distance=0.0011", "", Role::paper}, 600,
                  {90, 250})};
  e.sets[1].fidelity = Fidelity{0.05, 0.025, 0.5, 12.5, 90, 0.75, 0.25, 30.5, 28, 0.95, 0.9};
  e.sets[1].pictures = {"pictures/whole.png", "pictures/detail.png", "pictures/heat.png"};
  e.sets[2].visits[1].gl_ms.reset();
  return e;
}

/// A curve of two points, a peer, a literal reading and an order.
inline ExperimentResult beyond() {
  ExperimentResult e = paper1();
  e.name = "beyond";
  e.sets.resize(2);
  e.sets[1].definition.role = Role::curve;
  e.sets.push_back(timed({"vt-2", "VT, passes 2", "VT", "2", "vt:passes=2", "", Role::curve}, 200, {25, 50}));
  e.sets.back().fidelity = e.sets[1].fidelity;
  e.sets.back().fidelity->rms = 0.1;
  e.sets.push_back(
      timed({"meshopt-as-vt", "meshopt", "meshopt", "", "peer:meshopt", "vt", Role::peer}, 400, {50, 100}));
  e.sets.back().fidelity = e.sets[1].fidelity;
  e.sets.push_back(
      timed({"vt-literal", "VT literal", "VT", "", "vt:guard=-1", "vt", Role::literal}, 390, {50, 100}));
  e.sets.push_back(timed({"vt-cached", "vt", "", "", "", "vt", Role::cache}, 400, {40, 80}));
  return e;
}

inline Results results() {
  Results r;
  r.protocol = "quick";
  r.complete = true;
  r.settings = {640, 480, 6, 1000};
  r.environment = {"llvmpipe", "Mesa",    "4.5", "device 0", "A Processor",         2,
                   "GNU 12",   "Release", "abc", true,       "2024-01-02T03:04:05Z"};
  r.notes = {"Suzanne is not there"};
  r.experiments = {paper1(), beyond()};
  return r;
}

}  // namespace example
