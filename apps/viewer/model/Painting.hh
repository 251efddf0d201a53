/// \file
/// A picture drawn piece by piece, so that the window stays responsive.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace whittle::viewer {

/// One thing to draw, whole or in parts.
struct Stroke {
  std::size_t size = 0;  ///< how many triangles, lines or dots
  std::function<void(std::size_t first, std::size_t count)> draw;
};

/// Strokes one after the other. Each is cut into pieces whose size follows from how long the last one took:
/// a graphics card draws everything in a few pieces, a software renderer some thousand triangles at a time.
class Painting {
 public:
  /// Waits until all draw calls have finished, and returns the time in milliseconds.
  using Clock = std::function<double()>;

  explicit Painting(std::vector<Stroke> strokes = {}) : strokes_(std::move(strokes)) { skip_empty(); }

  bool done() const { return at_ == strokes_.size(); }
  double milliseconds() const { return spent_; }  ///< that drawing has taken so far

  /// Draws one piece, and more of them while there is time: for about so many milliseconds.
  void advance(double milliseconds, const Clock& clock);

  /// Draws all that is left at once.
  void finish();

 private:
  void skip_empty();

  std::vector<Stroke> strokes_;
  std::size_t at_ = 0, first_ = 0;  ///< the stroke, and what of it is drawn already
  std::size_t piece_ = kFirstPiece;
  double spent_ = 0;

  static constexpr std::size_t kFirstPiece = 1000;
};

}  // namespace whittle::viewer
