#include "measure/certify.hh"

#include <algorithm>

#include "measure/PieceSearch.hh"
#include "whittle/surface/errors.hh"

namespace whittle::measure {

CertifiedDistance certify(const IndexedMesh& original, const IndexedMesh& simplified, double tolerance,
                          unsigned threads, const Monitor& monitor) {
  PieceSearch search(original, simplified, threads, monitor);
  const double within = tolerance / search.unit() - search.slack();
  if (!(within > search.slack()))
    throw InvalidParameter(
        "the tolerance of a certified distance must be more than rounding makes of the coordinates");

  CertifiedDistance out;
  double lower = -1, upper = 0;
  search.run([&](const Piece& piece) {
    if (piece.lower() > lower) {
      lower = piece.lower();
      out.on_original = piece.on_original;
      const auto at =
          std::max_element(piece.distances.begin(), piece.distances.end()) - piece.distances.begin();
      out.farthest = piece.corners[static_cast<std::size_t>(at)] * search.unit();
    }
    if (piece.upper > lower + within) return PieceSearch::Fate::cut;
    upper = std::max(upper, piece.upper);
    return PieceSearch::Fate::done;
  });
  out.lower = std::max(0.0, lower - search.slack()) * search.unit();
  out.upper = upper * search.unit();
  out.pieces = search.pieces();
  return out;
}

}  // namespace whittle::measure
