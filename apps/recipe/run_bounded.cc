#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "measure/Excess.hh"
#include "recipe/Stage.hh"
#include "text/number.hh"

namespace whittle::recipe {
namespace {

/// A run and where it lies too far from the input.
struct Attempt {
  Result result;
  measure::Excess excess;

  bool holds() const { return excess.none(); }
};

bool has_area(const IndexedMesh& mesh) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
    const Eigen::Vector3d a = mesh.points[t[0]];
    return (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a).squaredNorm() > 0;
  });
}

/// How far points on a surface are measured from the same surface: a bound below that would never be kept.
double rounding(const IndexedMesh& mesh) {
  double largest = 0;
  for (const auto& p : mesh.points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return 16 * std::numeric_limits<double>::epsilon() * largest;
}

Attempt attempt(const Task& task, double bound) {
  Attempt tried{run_stages(task), {}};
  const IndexedMesh& after = tried.result.mesh;
  if (!has_area(task.mesh)) return tried;
  if (has_area(after)) {
    const auto go_on = [&](double) { return task.goes_on(task.stages.back(), after.triangles.size()); };
    try {
      tried.excess = measure::excess(task.mesh, after, bound, {task.samples, 0}, go_on);
    } catch (const measure::Cancelled&) {
      throw Cancelled();
    }
  } else {  // everything is gone
    constexpr double kFar = std::numeric_limits<double>::infinity();
    for (std::uint32_t v = 0; v < task.mesh.points.size(); ++v) tried.excess.original.push_back({v, kFar});
    tried.excess.max = kFar;
  }
  return tried;
}

Result finished(Attempt&& tried) {
  tried.result.distance = tried.excess.max;
  tried.result.bound_held = tried.holds();
  return std::move(tried.result);
}

Result stopped(Attempt&& tried) {
  Result result = finished(std::move(tried));
  result.stopped_by_bound = true;
  return result;
}

/// Whether the last stage takes the cheapest collapse first, so that where it stops is what counts.
bool goes_by_error(const Task& task) {
  const Spec& module = task.stages.back().module;
  return find_module(module.name).cheapest_first && !has_threshold(module);
}

/// How far off each vertex of the input is, together with the faces around it and around what it became; 0
/// where it is held already or within the bound.
std::vector<double> excess_of_vertices(const Attempt& tried, const std::vector<std::uint8_t>& flags) {
  const Result& after = tried.result;
  std::vector<double> far(after.vertex_map.size(), 0), far_after(after.mesh.points.size(), 0);
  for (const auto& [v, distance] : tried.excess.original) far[v] = distance;
  for (const auto& [w, distance] : tried.excess.simplified) far_after[w] = distance;
  for (std::size_t v = 0; v < far.size(); ++v)
    far[v] = flags[v] & kLocked ? 0 : std::max(far[v], far_after[after.vertex_map[v]]);
  return far;
}

/// Whether the recipe is one module that keeps a bound by itself.
bool keeps_bound_itself(const Task& task) {
  const Spec& module = task.stages.back().module;
  return task.stages.size() == 1 && !find_module(module.name).bound.empty() && !module.has("passes");
}

/// The module refuses what would take it too far, and goes on elsewhere. It looks at few points, so the whole
/// is measured afterwards; where that is too far much less is allowed, elsewhere a little, until all of it
/// keeps the bound. Nothing if that takes too many rounds.
std::optional<Result> refuse_on_the_way(Task task, double bound) {
  constexpr int kRounds = 20;
  constexpr double kLittle = 0.97, kMuch = 0.8, kMost = 0.4;  // factors of what was allowed
  Spec& module = task.stages.back().module;
  const std::string& key = find_module(module.name).bound;
  const double own = module.length(key, task.scale).value_or(bound);
  module.clear(key);
  module.set(key, text::shortest(std::min(bound, own)));
  task.extras.flags.resize(task.mesh.points.size(), 0);
  task.extras.tolerance.resize(task.mesh.points.size(), 1);
  for (int round = 0; round < kRounds; ++round) {
    Attempt tried = attempt(task, bound);
    if (tried.holds()) {
      Result result = finished(std::move(tried));
      result.stopped_by_bound = !task.is_target_met(result.mesh);
      return result;
    }
    const std::vector<double> far = excess_of_vertices(tried, task.extras.flags);
    for (std::size_t v = 0; v < far.size(); ++v) {
      const double factor = far[v] > 0 ? std::clamp(kMuch * bound / far[v], kMost, kMuch) : kLittle;
      task.extras.tolerance[v] *= static_cast<float>(factor);
    }
  }
  return std::nullopt;
}

/// Of a module that goes by error: the fewest faces, or vertices, that keep the bound.
Result stop_at_bound(Task task, double bound) {
  const bool has_target = task.target.any(), by_vertices = task.target.vertices > 0;
  std::size_t low = std::max<std::size_t>(1, by_vertices ? task.target.vertices : task.target.faces);
  std::size_t high = by_vertices ? task.mesh.points.size() : task.mesh.triangles.size();
  const auto at = [&](std::size_t count) {
    task.target = by_vertices ? TargetCount{0, count} : TargetCount{count, 0};
    return attempt(task, bound);
  };
  if (has_target || !keeps_bound_itself(task)) {
    Attempt all = at(low);
    if (all.holds()) return finished(std::move(all));
  } else {
    task.target = {low, 0};
  }
  if (keeps_bound_itself(task))
    if (auto kept = refuse_on_the_way(task, bound)) return std::move(*kept);
  Attempt best = at(high);
  while (high > low + 1 && static_cast<double>(high) > 1.004 * static_cast<double>(low)) {
    const auto middle =
        static_cast<std::size_t>(std::sqrt(static_cast<double>(low) * static_cast<double>(high)));
    const std::size_t count = std::clamp(middle, low + 1, high - 1);
    Attempt tried = at(count);
    if (tried.holds()) {
      high = count;
      best = std::move(tried);
    } else {
      low = count;
    }
  }
  return stopped(std::move(best));
}

/// The stage that has no threshold and no target to search one for, if there is one.
Stage* open_stage(Task& task) {
  if (task.target.any()) return nullptr;
  const auto found = std::find_if(task.stages.begin(), task.stages.end(), [](const Stage& stage) {
    const Module& module = find_module(stage.module.name);
    return !module.threshold.empty() && !module.ends_by_itself && !has_threshold(stage.module);
  });
  return found == task.stages.end() ? nullptr : &*found;
}

/// By how much a threshold may break the bound for a second attempt, with the places held where it does.
constexpr double kBeyond = 1.3;

/// The largest threshold that keeps the bound; the stage is left with a larger one.
Result stop_at_threshold(Task& task, Stage& stage, double bound) {
  const auto [first, last] = threshold_range(find_module(stage.module.name), task.scale);
  const Spec open = stage.module;
  const auto at = [&](double threshold) {
    stage.module = with_threshold(open, threshold);
    return attempt(task, bound);
  };
  double low = first / 8, high = first;
  Attempt best = at(low);
  while (high <= last) {
    Attempt tried = at(high);
    if (!tried.holds()) break;
    low = high;
    best = std::move(tried);
    high *= 2;
  }
  while (high - low > 0.01 * high) {
    const double middle = (low + high) / 2;
    Attempt tried = at(middle);
    if (tried.holds()) {
      low = middle;
      best = std::move(tried);
    } else {
      high = middle;
    }
  }
  stage.module = with_threshold(open, kBeyond * low);
  return stopped(std::move(best));
}

/// How much is held in a round. To hold the worst first leaves their neighbours room to do without; later
/// rounds make sure that it comes to an end soon.
enum class Grip { worst, all, all_and_neighbours };

/// \return how many vertices were not held before.
std::size_t hold(const Task& task, const Attempt& tried, Grip grip, std::vector<std::uint8_t>& flags) {
  const std::vector<double> far = excess_of_vertices(tried, flags);
  std::vector<double> around = far;  // the largest among a vertex and its neighbours
  for (const auto& t : task.mesh.triangles) {
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

Result hold_and_repeat(Task task, double bound) {
  constexpr int kWorstRounds = 12, kAllRounds = 16;
  task.extras.flags.resize(task.mesh.points.size(), 0);
  std::size_t held = 0;
  for (int round = 0;; ++round) {
    Attempt tried = attempt(task, bound);
    const Grip grip = round < kWorstRounds ? Grip::worst
                      : round < kAllRounds ? Grip::all
                                           : Grip::all_and_neighbours;
    const std::size_t added = tried.holds() ? 0 : hold(task, tried, grip, task.extras.flags);
    held += added;
    if (added > 0) continue;
    Result result = finished(std::move(tried));
    result.held_by_bound = held;
    result.stopped_by_bound = held > 0;
    return result;
  }
}

}  // namespace

Result run_bounded(const Task& task, double asked) {
  const double bound = std::max(asked, rounding(task.mesh));
  if (goes_by_error(task)) return stop_at_bound(task, bound);
  Task copy = task;
  if (Stage* stage = open_stage(copy)) {
    Result best = stop_at_threshold(copy, *stage, bound);
    Result second = hold_and_repeat(copy, bound);
    const bool is_better = second.bound_held && second.mesh.triangles.size() < best.mesh.triangles.size();
    return is_better || !best.bound_held ? second : best;
  }
  return hold_and_repeat(copy, bound);
}

}  // namespace whittle::recipe
