#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "measure/Excess.hh"
#include "recipe/run_stages.hh"
#include "whittle/surface/errors.hh"

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
    const auto go_on = [&](double) {
      return !work.monitor ||
             work.monitor({work.stages.size() - 1, work.stages.size(), after.triangles.size()});
    };
    try {
      tried.excess = measure::excess(work.mesh, after, bound, {}, go_on);
    } catch (const measure::Cancelled&) {
      throw Cancelled();
    }
  } else {  // everything is gone
    constexpr double kFar = std::numeric_limits<double>::infinity();
    for (std::uint32_t v = 0; v < work.mesh.points.size(); ++v) tried.excess.original.push_back({v, kFar});
    tried.excess.max = kFar;
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

/// How far off each vertex of the input is, together with the faces around it and around what it became; 0
/// where it is held already or within the bound.
std::vector<double> excess_of_vertices(const Tried& tried, const std::vector<std::uint8_t>& flags) {
  const Pass& sum = tried.ran.sum;
  std::vector<double> far(sum.vertex_map.size(), 0), far_after(sum.mesh.points.size(), 0);
  for (const auto& [v, distance] : tried.excess.original) far[v] = distance;
  for (const auto& [w, distance] : tried.excess.simplified) far_after[w] = distance;
  for (std::size_t v = 0; v < far.size(); ++v)
    far[v] = flags[v] & kLocked ? 0 : std::max(far[v], far_after[sum.vertex_map[v]]);
  return far;
}

/// mq refuses on the way what would take it too far, and goes on elsewhere. It looks at few points, so the
/// whole is measured then; where that is too far much less is allowed, elsewhere a little, as long as it
/// takes.
std::optional<BoundedRan> refuse_on_the_way(Work work, double bound) {
  constexpr int kRounds = 20;
  constexpr double kLittle = 0.97, kMuch = 0.8, kMost = 0.4;  // factors of what was allowed
  Spec& module = work.stages.back().module;
  if (module.name != "mq" || module.has("passes") || work.stages.size() > 1) return std::nullopt;
  module = with_max_distance(module, bound, work.scale);
  work.extras.flags.resize(work.mesh.points.size(), 0);
  work.extras.tolerance.resize(work.mesh.points.size(), 1);
  for (int round = 0; round < kRounds; ++round) {
    Tried tried = attempt(work, bound);
    if (tried.excess.none()) {
      BoundedRan out = finished(std::move(tried));
      out.stopped = !work.floor.reached(out.sum.mesh);
      return out;
    }
    const std::vector<double> far = excess_of_vertices(tried, work.extras.flags);
    for (std::size_t v = 0; v < far.size(); ++v) {
      const double factor = far[v] > 0 ? std::clamp(kMuch * bound / far[v], kMost, kMuch) : kLittle;
      work.extras.tolerance[v] *= static_cast<float>(factor);
    }
  }
  return std::nullopt;
}

/// Of a module that goes by error: the fewest faces, or vertices, that keep the bound.
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
  if (auto kept = refuse_on_the_way(work, bound)) return std::move(*kept);
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

/// By how much a threshold may break the bound for a second attempt, with the places held where it does.
constexpr double kBeyond = 1.3;

/// The largest threshold that keeps the bound; the stage is left with a larger one.
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
  stage.module = with_threshold(open, kBeyond * low);
  BoundedRan out = finished(std::move(best));
  out.stopped = true;
  return out;
}

/// How much is held in a round. To hold the worst first leaves their neighbours room to do without; later
/// rounds make sure that it comes to an end soon.
enum class Grip { worst, all, all_and_neighbours };

/// \return how many vertices were not held before.
std::size_t hold(const Work& work, const Tried& tried, Grip grip, std::vector<std::uint8_t>& flags) {
  const std::vector<double> far = excess_of_vertices(tried, flags);
  std::vector<double> around = far;  // the largest among a vertex and its neighbours
  for (const auto& t : work.mesh.triangles) {
    const double most = std::max({far[t[0]], far[t[1]], far[t[2]]});
    for (const std::uint32_t v : t) around[v] = std::max(around[v], most);
  }
  std::size_t added = 0;
  for (std::size_t v = 0; v < far.size(); ++v) {
    const bool is_chosen = grip == Grip::all_and_neighbours ? around[v] > 0
                           : grip == Grip::all              ? far[v] > 0
                                                            : far[v] > 0 && far[v] == around[v];
    if (!is_chosen || (flags[v] & kLocked)) continue;
    flags[v] |= kLocked;
    ++added;
  }
  return added;
}

BoundedRan hold_and_repeat(Work work, double bound) {
  constexpr int kWorstRounds = 12, kAllRounds = 16;
  work.extras.flags.resize(work.mesh.points.size(), 0);
  std::size_t held = 0;
  for (int round = 0;; ++round) {
    Tried tried = attempt(work, bound);
    const Grip grip = round < kWorstRounds ? Grip::worst
                      : round < kAllRounds ? Grip::all
                                           : Grip::all_and_neighbours;
    const std::size_t added = tried.excess.none() ? 0 : hold(work, tried, grip, work.extras.flags);
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
    BoundedRan second = hold_and_repeat(copy, bound);
    const bool is_better = second.held && second.sum.mesh.triangles.size() < best.sum.mesh.triangles.size();
    return is_better || !best.held ? second : best;
  }
  return hold_and_repeat(copy, bound);
}

}  // namespace whittle::recipe
