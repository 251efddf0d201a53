#include "model/Painting.hh"

#include <algorithm>

namespace whittle::viewer {
namespace {

constexpr std::size_t kLeastPiece = 200;
constexpr double kPieces = 4;  // so many should fit into the time there is: the last one runs over by little

std::size_t next_piece(std::size_t count, double milliseconds, double wanted) {
  const double factor = std::clamp(wanted / std::max(milliseconds, 1e-6), 0.125, 4.0);
  return std::max(kLeastPiece, static_cast<std::size_t>(factor * static_cast<double>(count)));
}

}  // namespace

void Painting::skip_empty() {
  while (!done() && first_ >= strokes_[at_].size) {
    ++at_;
    first_ = 0;
    piece_ = kFirstPiece;
  }
}

void Painting::advance(double milliseconds, const Clock& clock) {
  const double start = clock();
  double now = start, last = 0;
  while (!done() && now - start + last / 2 <= milliseconds) {
    const Stroke& stroke = strokes_[at_];
    const std::size_t count = std::min(piece_, stroke.size - first_);
    stroke.draw(first_, count);
    last = -now;
    now = clock();
    last += now;
    spent_ += last;
    // A rest smaller than a piece is no measure of how long a piece takes.
    if (count == piece_) piece_ = next_piece(count, last, milliseconds / kPieces);
    first_ += count;
    skip_empty();
  }
}

void Painting::finish() {
  for (; !done(); skip_empty()) {
    const Stroke& stroke = strokes_[at_];
    stroke.draw(first_, stroke.size - first_);
    first_ = stroke.size;
  }
}

}  // namespace whittle::viewer
