#include "measure/PieceSearch.hh"

#include <cmath>
#include <limits>
#include <thread>
#include <tuple>
#include <utility>

#include "measure/ClosestFace.hh"
#include "measure/Surface.hh"
#include "measure/blocks.hh"
#include "whittle/surface/triangle.hh"

namespace whittle::measure {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

double largest_coordinate(const IndexedMesh& mesh) {
  double largest = 0;
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t) largest = std::max(largest, mesh.points[v].cwiseAbs().maxCoeff());
  return largest;
}

/// No closer point of the triangle is needed: any is an upper bound. So shares that rounding has spoilt are put right.
double distance_to(const Eigen::Vector3d& p, const Corners& t) {
  return whittle::detail::at_closest_point(
      p, t.a, t.b, t.c, [&](const Eigen::Vector3d& corner, const auto&... step) {
        double left = 1;
        Eigen::Vector3d offset = p - corner;
        [[maybe_unused]] const auto go = [&](const auto& s) {
          const double share = s.share > 0 ? std::min(s.share, left) : 0;  // not a number: 0
          left -= share;
          offset -= share * s.side;
        };
        (go(step), ...);
        return offset.norm();
      });
}

}  // namespace

/// One of the surfaces and the tree over it.
struct PieceSearch::Side {
  Side(IndexedMesh&& scaled_mesh, const IndexedMesh& mesh, unsigned threads,
       const std::function<bool()>& go_on)
      : scaled(std::move(scaled_mesh)),
        surface(scaled.triangles.empty() ? mesh : scaled, Surface::Part::all),
        closest(surface, threads, go_on) {}

  IndexedMesh scaled;  // empty where the mesh needs no scaling
  Surface surface;
  ClosestFace closest;
};

PieceSearch::PieceSearch(const IndexedMesh& original, const IndexedMesh& simplified, unsigned threads,
                         const Monitor& monitor)
    : threads_(threads == 0 ? std::max(1u, std::thread::hardware_concurrency()) : threads),
      watch_(monitor, 2.0 * static_cast<double>(original.points.size() + simplified.points.size() +
                                                original.triangles.size() + simplified.triangles.size())) {
  const double largest = std::max(largest_coordinate(original), largest_coordinate(simplified));
  const int exponent = std::isfinite(largest) && largest > 0 ? std::ilogb(largest) : 0;
  constexpr int kModest = 100;  // products of four coordinates are far from overflow then
  if (std::abs(exponent) > kModest) unit_ = std::ldexp(1.0, exponent);
  constexpr double kUnitsInTheLastPlace =
      256;  // a hundred cuts one after the other, and a point on a triangle
  slack_ = kUnitsInTheLastPlace * kEpsilon * (largest / unit_);

  const auto go_on = [this] { return watch_.done(0); };
  const auto side = [&](const IndexedMesh& mesh) {
    IndexedMesh scaled;
    if (unit_ != 1) {
      scaled = mesh;
      for (auto& p : scaled.points) p /= unit_;
    }
    return std::make_unique<const Side>(std::move(scaled), mesh, threads_, go_on);
  };
  original_ = side(original);
  simplified_ = side(simplified);
}

PieceSearch::~PieceSearch() = default;

void PieceSearch::bound(Piece& piece) const {
  const Side& other = other_side(piece.on_original);
  const auto& c = piece.corners;
  // A point of a triangle is no farther from the nearest corner than this.
  const double longest = std::sqrt(
      std::max({(c[1] - c[0]).squaredNorm(), (c[2] - c[1]).squaredNorm(), (c[0] - c[2]).squaredNorm()}));
  double upper = piece.lower() + longest / std::sqrt(3.0);
  const std::uint32_t candidates[] = {piece.best, piece.nearest[0], piece.nearest[1], piece.nearest[2]};
  for (std::size_t i = 0; i < 4; ++i) {
    if (std::find(candidates, candidates + i, candidates[i]) != candidates + i) continue;
    const Corners face = other.surface.face(candidates[i]);
    double most = 0;
    for (std::size_t k = 0; k < 3 && most < upper; ++k) most = std::max(most, distance_to(c[k], face));
    if (!(most < upper)) continue;
    upper = most;
    piece.best = candidates[i];
  }
  piece.upper = upper * (1 + 16 * kEpsilon) + slack_;
}

std::vector<Piece> PieceSearch::faces_of(bool of_original) {
  const Side &side = of_original ? *original_ : *simplified_, &other = other_side(of_original);
  const Surface& surface = side.surface;
  const auto& vertices = surface.vertices();
  const Crew crew{threads_, watch_};

  const auto found = in_blocks<std::vector<ClosestFace::Answer>>(
      vertices.size(), crew, [&](std::size_t begin, std::size_t end) {
        std::vector<ClosestFace::Answer> answers;
        for (std::size_t i = begin; i < end; ++i)
          answers.push_back(other.closest.closest(surface.point(vertices[i])));
        return answers;
      });
  std::vector<std::pair<double, std::uint32_t>> of_vertex(vertices.empty() ? 0 : vertices.back() + 1);
  std::size_t at = 0;
  for (const auto& block : found)
    for (const auto& [squared, face] : block)
      of_vertex[vertices[at++]] = {std::sqrt(squared), static_cast<std::uint32_t>(face)};

  auto blocks = in_blocks<std::vector<Piece>>(surface.size(), crew, [&](std::size_t begin, std::size_t end) {
    std::vector<Piece> pieces;
    for (std::size_t i = begin; i < end; ++i) {
      Piece piece{};
      piece.face = surface.index(i);
      piece.on_original = of_original;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = surface.triangle(i)[k];
        piece.corners[k] = surface.point(v);
        std::tie(piece.distances[k], piece.nearest[k]) = of_vertex[v];
      }
      const Eigen::Vector3d centroid = (piece.corners[0] + piece.corners[1] + piece.corners[2]) / 3;
      const double known = distance_to(centroid, other.surface.face(piece.nearest[0]));
      piece.best =
          static_cast<std::uint32_t>(other.closest.closest(centroid, {known * known, piece.nearest[0]}).face);
      bound(piece);
      pieces.push_back(piece);
    }
    return pieces;
  });
  std::vector<Piece> all;
  all.reserve(surface.size());
  for (const auto& block : blocks) all.insert(all.end(), block.begin(), block.end());
  return all;
}

std::array<Piece, 2> PieceSearch::halves(const Piece& piece) const {
  const auto& c = piece.corners;
  std::size_t i = 0;  // where the longest edge starts
  double longest = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double square = (c[(k + 1) % 3] - c[k]).squaredNorm();
    if (square > longest) {
      longest = square;
      i = k;
    }
  }
  const std::size_t j = (i + 1) % 3;
  const Eigen::Vector3d middle = 0.5 * c[i] + 0.5 * c[j];

  const Side& other = other_side(piece.on_original);
  ClosestFace::Answer known{std::numeric_limits<double>::infinity(), 0};
  for (const std::uint32_t face : {piece.best, piece.nearest[0], piece.nearest[1], piece.nearest[2]}) {
    const double distance = distance_to(middle, other.surface.face(face));
    if (distance * distance < known.squared_distance) known = {distance * distance, face};
  }
  const auto [squared, face] = other.closest.closest(middle, known);

  std::array<Piece, 2> out{piece, piece};
  for (std::size_t h = 0; h < 2; ++h) {
    const std::size_t k = h == 0 ? j : i;  // the corner that becomes the middle
    out[h].corners[k] = middle;
    out[h].distances[k] = std::sqrt(squared);
    out[h].nearest[k] = static_cast<std::uint32_t>(face);
    bound(out[h]);
  }
  return out;
}

void PieceSearch::run(const std::function<Fate(const Piece&)>& decide) {
  std::vector<Piece> waiting = faces_of(true);
  {
    const std::vector<Piece> others = faces_of(false);
    waiting.insert(waiting.end(), others.begin(), others.end());
  }
  // The worst come first: what they show of the distance rules others out.
  std::stable_sort(waiting.begin(), waiting.end(),
                   [](const Piece& a, const Piece& b) { return a.upper < b.upper; });

  constexpr std::size_t kAtOnce = 8 * kBlock;  // so that there is work for several threads, and little waits
  const Crew crew{threads_, watch_};
  std::vector<Piece> to_cut;
  while (!waiting.empty()) {
    to_cut.clear();
    while (!waiting.empty() && to_cut.size() < kAtOnce) {
      ++pieces_;
      if (decide(waiting.back()) == Fate::cut) to_cut.push_back(waiting.back());
      waiting.pop_back();
    }
    const auto blocks =
        in_blocks<std::vector<Piece>>(to_cut.size(), crew, [&](std::size_t begin, std::size_t end) {
          std::vector<Piece> pieces;
          pieces.reserve(2 * (end - begin));
          for (std::size_t i = begin; i < end; ++i)
            for (const Piece& half : halves(to_cut[i])) pieces.push_back(half);
          return pieces;
        });
    for (const auto& block : blocks) waiting.insert(waiting.end(), block.begin(), block.end());
  }
}

}  // namespace whittle::measure
