/// \file
/// Undo and redo.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace whittle::viewer {

/// The states of something, and which of them holds now.
template <typename State>
class History {
 public:
  explicit History(State first = {}) : states_{std::move(first)} {}

  const State& now() const { return states_[at_]; }

  /// Goes to a new state; what had been undone is gone. Changes in a row with the same tag, as those of one
  /// drag of a slider, are undone together. An empty tag stands for itself.
  void change(State state, const std::string& tag = "") {
    const bool merge = !tag.empty() && tag == tag_ && at_ + 1 == states_.size() && at_ > 0;
    states_.resize(at_ + 1);
    if (merge) {
      states_.back() = std::move(state);
    } else {
      states_.push_back(std::move(state));
      ++at_;
    }
    tag_ = tag;
    if (states_.size() > kLimit) {
      states_.erase(states_.begin());
      --at_;
    }
  }

  /// The next change begins a new step, whatever its tag.
  void seal() { tag_.clear(); }

  bool can_undo() const { return at_ > 0; }
  bool can_redo() const { return at_ + 1 < states_.size(); }
  void undo() {
    if (can_undo()) --at_;
    seal();
  }
  void redo() {
    if (can_redo()) ++at_;
    seal();
  }

 private:
  static constexpr std::size_t kLimit = 500;

  std::vector<State> states_;
  std::size_t at_ = 0;
  std::string tag_;
};

}  // namespace whittle::viewer
