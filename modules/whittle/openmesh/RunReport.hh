/// \file
/// What a run of a driver came to, and why it went no further.
#pragma once

#include <cstddef>
#include <string>

#include "whittle/plan/CollapsePlan.hh"

namespace whittle {

namespace detail {

/// Why a target was missed, in one line: counts and what they count.
class Reasons {
 public:
  void add(std::size_t n, const char* what) {
    if (n > 0) text_ += (text_.empty() ? "" : "; ") + std::to_string(n) + what;
  }
  /// What a planner refused.
  void add(const PlanRecord& record) {
    add(record.refused_by_flip_guard, " merges refused by the flip guard");
    add(record.refused_by_link, " merges refused by the link condition");
    add(record.refused_by_seam, " merges refused by seams");
    add(record.refused_by_bound, " merges refused by max_distance");
  }
  std::string or_else(const char* text) const { return text_.empty() ? text : text_; }

 private:
  std::string text_;
};

}  // namespace detail

/// What a run of a driver came to. The second half says why there was no further collapse; it is filled in where a
/// target was missed, and 0 otherwise.
struct RunReport {
  std::size_t collapses = 0;            ///< carried out in this run
  std::size_t faces = 0, vertices = 0;  ///< left, without deleted ones
  bool target_reached = true;           ///< the run's or else the module's own; true where there is none
  bool halted = false;                  ///< the observer called a halt

  /// Vertices that are locked, features, or not selected where only selected ones may go.
  std::size_t held = 0;
  /// Vertices that no legal collapse removes: link condition, boundary.
  std::size_t illegal = 0;
  /// Vertices with a legal collapse, which a module forbids: threshold, guard, constraint.
  std::size_t forbidden = 0;
  /// Planned collapses that another module forbids, or that have become illegal.
  std::size_t refused = 0;
  PlanRecord record;  ///< what the planner refused; empty without a module that has a plan

  /// One line, in order of what weighs most for a user; empty where the target was reached.
  std::string why() const {
    if (target_reached) return {};
    if (halted) return "the observer called a halt";
    detail::Reasons reasons;
    reasons.add(held, " vertices are locked, features or not selected");
    reasons.add(record);
    reasons.add(refused, " planned collapses refused by other modules or illegal by now");
    reasons.add(illegal, " vertices have no legal collapse");
    reasons.add(
        forbidden,
        " vertices have legal collapses that the modules forbid: a threshold, a constraint, or the end "
        "of the passes (set_passes)");
    return reasons.or_else("nothing is left that could collapse");
  }
};

}  // namespace whittle
