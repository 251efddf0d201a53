/// \file
/// Whether sides of a polygon cross.
#include <set>

#include "files/PlanePoints.hh"
#include "whittle/surface/orientation.hh"

namespace whittle::files {
namespace {

int exact_turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return detail::orient2d({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
}

/// From left to right; of those with the same x from below.
bool lies_before(const PlanePoint& a, const PlanePoint& b) {
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

class Sweep {
 public:
  explicit Sweep(const std::vector<PlanePoint>& at)
      : at_(at), order_(Below{this}), places_(at.size(), order_.end()) {}

  bool finds_crossing() {
    std::vector<Event> events;
    for (std::uint32_t side = 0; side < at_.size(); ++side) {
      if (!lies_before(left(side), right(side))) continue;  // no length
      events.push_back({left(side), side, false});
      events.push_back({right(side), side, true});
    }
    std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) {
      if (lies_before(a.at, b.at) || lies_before(b.at, a.at)) return lies_before(a.at, b.at);
      return a.ends != b.ends ? a.ends : a.side < b.side;  // what ends makes room first
    });
    return std::any_of(events.begin(), events.end(),
                       [&](const Event& event) { return event.ends ? take(event.side) : put(event.side); });
  }

 private:
  struct Event {
    PlanePoint at;
    std::uint32_t side;
    bool ends;
  };
  /// Of two sides that are both there at some x, the lower one.
  struct Below {
    const Sweep* sweep;
    bool operator()(std::uint32_t a, std::uint32_t b) const { return sweep->is_below(a, b); }
  };
  using Order = std::set<std::uint32_t, Below>;

  std::uint32_t end_of(std::uint32_t side) const { return side + 1 == at_.size() ? 0 : side + 1; }
  const PlanePoint& left(std::uint32_t side) const {
    const PlanePoint &a = at_[side], &b = at_[end_of(side)];
    return lies_before(a, b) ? a : b;
  }
  const PlanePoint& right(std::uint32_t side) const {
    const PlanePoint &a = at_[side], &b = at_[end_of(side)];
    return lies_before(a, b) ? b : a;
  }

  /// \return 1: the left end of the side, or where that lies on the other one, its right end lies above it; -1: below
  int height(std::uint32_t side, std::uint32_t other) const {
    const int turn = exact_turn(left(other), right(other), left(side));
    return turn != 0 ? turn : exact_turn(left(other), right(other), right(side));
  }

  bool is_below(std::uint32_t a, std::uint32_t b) const {
    if (a == b) return false;
    const bool b_begins_later = lies_before(left(a), left(b));
    const int turn = b_begins_later ? height(b, a) : -height(a, b);
    return turn != 0 ? turn > 0 : a < b;
  }

  bool cross(std::uint32_t a, std::uint32_t b) const {
    return sides_cross(at_[a], at_[end_of(a)], at_[b], at_[end_of(b)]);
  }

  bool put(std::uint32_t side) {
    const auto at = order_.insert(side).first;
    places_[side] = at;
    const auto above = std::next(at);
    return (at != order_.begin() && cross(*std::prev(at), side)) ||
           (above != order_.end() && cross(side, *above));
  }

  bool take(std::uint32_t side) {
    const auto above = order_.erase(places_[side]);
    return above != order_.end() && above != order_.begin() && cross(*std::prev(above), *above);
  }

  const std::vector<PlanePoint>& at_;
  Order order_;
  std::vector<Order::iterator> places_;
};

}  // namespace

bool any_sides_cross(const std::vector<PlanePoint>& at) {
  return Sweep(at).finds_crossing();
}

}  // namespace whittle::files
