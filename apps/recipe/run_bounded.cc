#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "measure/Excess.hh"
#include "recipe/run_stages.hh"
#include "whittle/errors.hh"

namespace whittle::recipe {
namespace {

/// A run and where it lies too far from the input.
struct Tried {
  Ran ran;
  measure::Excess excess;
};

bool has_area(const IndexedMesh& mesh) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
    const Eigen::Vector3d a = mesh.points[t[0]];
    return (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a).squaredNorm() > 0;
  });
}

Tried attempt(const Work& work, double bound) {
  Tried tried{run_stages(work), {}};
  const IndexedMesh& after = tried.ran.sum.mesh;
  if (!has_area(work.mesh)) return tried;
  if (has_area(after)) {
    tried.excess = measure::excess(work.mesh, after, bound);
  } else {  // everything is gone
    tried.excess.original.resize(work.mesh.points.size());
    std::iota(tried.excess.original.begin(), tried.excess.original.end(), 0u);
    tried.excess.max = std::numeric_limits<double>::infinity();
  }
  return tried;
}

BoundedRan finished(Tried&& tried) {
  BoundedRan out{std::move(tried.ran)};
  out.distance = tried.excess.max;
  out.held = tried.excess.none();
  return out;
}

/// Whether the last stage takes the cheapest collapse first, so that where it stops is what counts.
bool goes_by_error(const Work& work) {
  const Spec& module = work.stages.back().module;
  return module.name == "mq" || (module.name == "quadric" && !has_threshold(module));
}

/// The fewest faces, or vertices, that keep the bound.
BoundedRan stop_at_bound(Work work, double bound) {
  const bool by_vertices = work.floor.vertices > 0;
  std::size_t low = std::max<std::size_t>(1, by_vertices ? work.floor.vertices : work.floor.faces);
  std::size_t high = by_vertices ? work.mesh.points.size() : work.mesh.triangles.size();
  const auto at = [&](std::size_t count) {
    work.floor = by_vertices ? Floor{0, count} : Floor{count, 0};
    return attempt(work, bound);
  };
  Tried best = at(low);
  if (best.excess.none()) return finished(std::move(best));
  best = at(high);
  while (high > low + 1 && static_cast<double>(high) > 1.004 * static_cast<double>(low)) {
    const auto middle =
        static_cast<std::size_t>(std::sqrt(static_cast<double>(low) * static_cast<double>(high)));
    const std::size_t count = std::clamp(middle, low + 1, high - 1);
    Tried tried = at(count);
    if (tried.excess.none()) {
      high = count;
      best = std::move(tried);
    } else {
      low = count;
    }
  }
  BoundedRan out = finished(std::move(best));
  out.stopped = true;
  return out;
}

/// The stage that has no threshold and no target to search one for, if there is one.
Stage* open_stage(Work& work) {
  if (work.floor.any()) return nullptr;
  const auto found = std::find_if(work.stages.begin(), work.stages.end(), [](const Stage& stage) {
    return !has_threshold(stage.module) && !has_default_threshold(stage.module);
  });
  return found == work.stages.end() ? nullptr : &*found;
}

/// The largest threshold that keeps the bound.
BoundedRan stop_at_threshold(Work& work, Stage& stage, double bound) {
  const auto [first, last] = threshold_range(make_planner(stage.module, work.scale), work.scale);
  const Spec open = stage.module;
  const auto at = [&](double threshold) {
    stage.module = with_threshold(open, threshold);
    return attempt(work, bound);
  };
  double low = first / 8, high = first;
  Tried best = at(low);
  for (; high <= last; high *= 2) {
    Tried tried = at(high);
    if (!tried.excess.none()) break;
    low = high;
    best = std::move(tried);
  }
  while (high - low > 0.01 * high) {
    const double middle = (low + high) / 2;
    Tried tried = at(middle);
    if (tried.excess.none()) {
      low = middle;
      best = std::move(tried);
    } else {
      high = middle;
    }
  }
  stage.module = with_threshold(open, low);
  BoundedRan out = finished(std::move(best));
  out.stopped = true;
  return out;
}

/// Holds the vertices around the places that lie too far. \return how many were not held before.
std::size_t hold(const Work& work, const Tried& tried, bool and_neighbours,
                 std::vector<std::uint8_t>& flags) {
  std::vector<bool> far(work.mesh.points.size(), false), far_after(tried.ran.sum.mesh.points.size(), false);
  for (const std::uint32_t v : tried.excess.original) far[v] = true;
  for (const std::uint32_t w : tried.excess.simplified) far_after[w] = true;
  for (std::size_t v = 0; v < far.size(); ++v)
    if (far_after[tried.ran.sum.vertex_map[v]]) far[v] = true;
  if (and_neighbours) {
    const std::vector<bool> inner = far;
    for (const auto& t : work.mesh.triangles)
      if (inner[t[0]] || inner[t[1]] || inner[t[2]]) far[t[0]] = far[t[1]] = far[t[2]] = true;
  }
  std::size_t added = 0;
  for (std::size_t v = 0; v < far.size(); ++v) {
    if (!far[v] || (flags[v] & kLocked)) continue;
    flags[v] |= kLocked;
    ++added;
  }
  return added;
}

BoundedRan hold_and_repeat(Work work, double bound) {
  work.extras.flags.resize(work.mesh.points.size(), 0);
  constexpr int kExactRounds = 4;  // then whole neighbourhoods, so that it comes to an end soon
  std::size_t held = 0;
  for (int round = 0;; ++round) {
    Tried tried = attempt(work, bound);
    const std::size_t added =
        tried.excess.none() ? 0 : hold(work, tried, round >= kExactRounds, work.extras.flags);
    held += added;
    if (added > 0) continue;
    BoundedRan out = finished(std::move(tried));
    out.held_vertices = held;
    out.stopped = held > 0;
    return out;
  }
}

}  // namespace

BoundedRan run_bounded(const Work& work, double bound) {
  if (goes_by_error(work)) return stop_at_bound(work, bound);
  Work copy = work;
  if (Stage* stage = open_stage(copy)) {
    BoundedRan best = stop_at_threshold(copy, *stage, bound);
    if (best.held) return best;  // else even the least threshold breaks it here and there
  }
  return hold_and_repeat(copy, bound);
}

}  // namespace whittle::recipe
