#include "files/pairing.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>

#include "files/manifold.hh"
#include "measure/sides.hh"
#include "whittle/surface/UnionFind.hh"

namespace whittle::files {
namespace {

using Eigen::Vector3d;
using measure::next_corner;
using measure::opposite_corner;
using measure::Side;

/// Two sides that meet, each named by the corner where it starts; or two faces.
struct Pair {
  std::uint32_t one, other;
};

class Pairing {
 public:
  Pairing(const IndexedMesh& mesh, const std::vector<std::uint32_t>& place, const JoinOptions& options)
      : mesh_(mesh),
        place_(place),
        turns_(options.turns || options.soup),
        is_soup_(options.soup),
        at_(mesh.triangles),
        pieces_(at_.size()) {
    for (IndexedMesh::Triangle& triangle : at_)
      for (std::uint32_t& corner : triangle) corner = place[corner];
    for (std::uint32_t face = 0; face < at_.size(); ++face)
      if (measure::has_vertex_twice(at_[face])) collapsing_.push_back(face);
    sides_ = measure::sides_by_edge(at_, mesh.points.size(), measure::Faces::proper);
    if (is_soup_) set_alike_aside();
  }

  Joined run() {
    for_each_edge(sides_, [&](const Side* begin, const Side* end) { pair_certain(begin, end); });
    for (const auto& [begin, end] : ambiguous_) pair_ambiguous(begin, end);
    std::vector<bool> is_apart(mesh_.points.size(), false);
    detail::UnionFind vertices = joined_vertices(is_apart);
    while (part_crowded(vertices, is_apart) || part_touching(vertices, is_apart))
      vertices = joined_vertices(is_apart);
    Joined joined;
    joined.root.resize(mesh_.points.size());
    for (std::uint32_t v = 0; v < joined.root.size(); ++v) joined.root[v] = vertices.root(v);
    joined.opposed = opposed_;
    return joined;
  }

 private:
  /// Takes faces on the places of an earlier one out of the pairing: they will have its vertices.
  void set_alike_aside() {
    const std::vector<std::uint32_t> first = first_alike(at_, sides_);
    for (std::uint32_t face = 0; face < first.size(); ++face)
      if (first[face] != face) alike_.push_back({face, first[face]});
    if (alike_.empty()) return;
    const auto is_aside = [&](const Side& side) { return first[side.face()] != side.face(); };
    sides_.erase(std::remove_if(sides_.begin(), sides_.end(), is_aside), sides_.end());
  }

  bool is_up(std::uint32_t corner) const { return place_at(corner) < place_at(next_corner(corner)); }
  std::uint32_t place_at(std::uint32_t corner) const { return measure::vertex_of(at_, corner); }
  std::uint32_t vertex_at(std::uint32_t corner) const { return measure::vertex_of(mesh_.triangles, corner); }

  /// The vertices at the lower and the higher end of a side.
  std::pair<std::uint32_t, std::uint32_t> ends(std::uint32_t corner) const {
    const std::uint32_t from = vertex_at(corner), to = vertex_at(next_corner(corner));
    return is_up(corner) ? std::pair(from, to) : std::pair(to, from);
  }

  /// Whether two faces at an edge lie on the same three places: front and back of a sheet, or twice the same.
  bool coincide(std::uint32_t one, std::uint32_t other) const {
    return place_at(opposite_corner(one)) == place_at(opposite_corner(other));
  }

  /// The sides of an edge that no other side shares its vertices with. Those that do are as the file has them.
  std::vector<std::uint32_t> free_sides(const Side* begin, const Side* end) {
    std::vector<std::uint32_t> corners;
    for (const Side* side = begin; side < end; ++side) corners.push_back(side->corner);
    std::sort(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(ends(a), a) < std::pair(ends(b), b);
    });
    std::vector<std::uint32_t> out;
    for (std::size_t i = 0, k = 0; i < corners.size(); i = k) {
      for (k = i + 1; k < corners.size() && ends(corners[k]) == ends(corners[i]); ++k)
        pieces_.join(corners[i] / 3, corners[k] / 3);
      if (k == i + 1) out.push_back(corners[i]);
    }
    std::sort(out.begin(), out.end());
    return out;
  }

  void pair(std::uint32_t one, std::uint32_t other) {
    pairs_.push_back({one, other});
    pieces_.join(one / 3, other / 3);
  }

  void pair_certain(const Side* begin, const Side* end) {
    if (end - begin == 2) return pair_two(begin[0].corner, begin[1].corner);
    if (end - begin < 2) return;
    const std::vector<std::uint32_t> free = free_sides(begin, end);
    if (free.size() == 2) pair_two(free[0], free[1]);
    if (free.size() > 2) ambiguous_.push_back({begin, end});
  }

  void pair_two(std::uint32_t one, std::uint32_t other) {
    if (ends(one) == ends(other))
      pieces_.join(one / 3, other / 3);
    else if (coincide(one, other))
      return;
    else if (is_up(one) != is_up(other))
      pair(one, other);
    else
      pair_opposed(one, other);
  }

  /// Two sides of the same direction: of a surface whose faces are turned, or of two that lie over one another.
  void pair_opposed(std::uint32_t one, std::uint32_t other) {
    if (is_soup_) return pair(one, other);
    const Vector3d a = point(one), along = (point(next_corner(one)) - a).normalized();
    const auto across = [&](std::uint32_t corner) {
      const Vector3d d = point(opposite_corner(corner)) - a;
      return Vector3d(d - d.dot(along) * along);
    };
    if (!(across(one).dot(across(other)) < 0)) return;
    if (turns_)
      pair(one, other);
    else
      ++opposed_;
  }

  void pair_ambiguous(const Side* begin, const Side* end) {
    constexpr std::size_t kMost = 64;  // more faces at one edge are no surface
    std::vector<std::uint32_t> free = free_sides(begin, end);
    if (free.size() > kMost) return;
    // First those of one piece, where it has two.
    const auto piece_less = [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(pieces_.root(a / 3), a) < std::pair(pieces_.root(b / 3), b);
    };
    std::sort(free.begin(), free.end(), piece_less);
    std::vector<std::uint32_t> up, down;
    for (std::size_t i = 0, k = 0; i < free.size(); i = k) {
      for (k = i + 1; k < free.size() && pieces_.root(free[k] / 3) == pieces_.root(free[i] / 3); ++k)
        continue;
      if (k == i + 2 && is_up(free[i]) != is_up(free[i + 1]) && !coincide(free[i], free[i + 1])) {
        pair(free[i], free[i + 1]);
        continue;
      }
      for (std::size_t n = i; n < k; ++n) (is_up(free[n]) ? up : down).push_back(free[n]);
    }
    pair_flattest(up, down);
  }

  /// Then those between which the surface turns least.
  void pair_flattest(const std::vector<std::uint32_t>& up, const std::vector<std::uint32_t>& down) {
    std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> turns;
    for (const std::uint32_t a : up)
      for (const std::uint32_t b : down)
        if (!coincide(a, b)) turns.emplace_back(-normal(a / 3).dot(normal(b / 3)), a, b);
    std::sort(turns.begin(), turns.end());
    std::vector<std::uint32_t> taken;
    const auto is_taken = [&](std::uint32_t corner) {
      return std::find(taken.begin(), taken.end(), corner) != taken.end();
    };
    for (const auto& [turn, a, b] : turns) {
      if (is_taken(a) || is_taken(b)) continue;
      pair(a, b);
      taken.insert(taken.end(), {a, b});
    }
  }

  Vector3d point(std::uint32_t corner) const { return mesh_.points[vertex_at(corner)]; }
  Vector3d normal(std::uint32_t face) const {
    return (point(3 * face + 1) - point(3 * face))
        .cross(point(3 * face + 2) - point(3 * face))
        .stableNormalized();
  }

  /// \param is_apart  places whose vertices are not joined
  detail::UnionFind joined_vertices(const std::vector<bool>& is_apart) const {
    detail::UnionFind vertices(mesh_.points.size());
    for (const std::uint32_t face : collapsing_)
      for (std::uint32_t corner = 3 * face; corner < 3 * face + 3; ++corner)
        if (place_at(corner) == place_at(next_corner(corner)) && !is_apart[place_at(corner)])
          vertices.join(vertex_at(corner), vertex_at(next_corner(corner)));
    for (const Pair& faces : alike_)
      for (std::uint32_t a = 3 * faces.one; a < 3 * faces.one + 3; ++a)
        for (std::uint32_t b = 3 * faces.other; b < 3 * faces.other + 3; ++b)
          if (place_at(a) == place_at(b) && !is_apart[place_at(a)]) vertices.join(vertex_at(a), vertex_at(b));
    for (const Pair& pair : pairs_) {
      const auto [low, high] = ends(pair.one);
      if (is_apart[place_[low]] || is_apart[place_[high]]) continue;
      const auto [other_low, other_high] = ends(pair.other);
      vertices.join(low, other_low);
      vertices.join(high, other_high);
    }
    return vertices;
  }

  /// Finds edges that joining would give a third face, or a second one of the same direction; one end of each is not
  /// to be joined.
  /// \return whether there are any
  bool part_crowded(detail::UnionFind& vertices, std::vector<bool>& is_apart) const {
    bool any = false;
    std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> at;  // joined ends, corner
    for_each_edge(sides_, [&](const Side* begin, const Side* end) {
      if (end - begin < 2) return;
      if (end - begin == 2 && (turns_ || is_up(begin[0].corner) != is_up(begin[1].corner))) return;
      at.clear();
      for (const Side* side = begin; side < end; ++side) {
        const auto [low, high] = ends(side->corner);
        at.emplace_back(vertices.root(low), vertices.root(high), side->corner);
      }
      std::sort(at.begin(), at.end());
      for (std::size_t i = 0, k = 0; i < at.size(); i = k) {
        const auto edge_of = [&](std::size_t n) { return std::pair(std::get<0>(at[n]), std::get<1>(at[n])); };
        for (k = i + 1; k < at.size() && edge_of(k) == edge_of(i);) ++k;
        const bool is_fine =
            k - i < 2 ||
            (k - i == 2 && (turns_ || is_up(std::get<2>(at[i])) != is_up(std::get<2>(at[i + 1]))));
        if (is_fine) continue;
        bool differs_low = false, differs_high = false;
        for (std::size_t n = i + 1; n < k; ++n) {
          differs_low |= ends(std::get<2>(at[n])).first != ends(std::get<2>(at[i])).first;
          differs_high |= ends(std::get<2>(at[n])).second != ends(std::get<2>(at[i])).second;
        }
        if (!differs_low && !differs_high) continue;  // so it is in the file
        is_apart[differs_low ? begin->low : begin->high] = true;
        any = true;
      }
    });
    return any;
  }

  /// Finds vertices that joining would give a second fan of faces, as only the ends of an edge at one place can.
  /// \return whether there are any
  bool part_touching(detail::UnionFind& vertices, std::vector<bool>& is_apart) const {
    if (collapsing_.empty()) return false;
    IndexedMesh joined;
    joined.points = mesh_.points;
    std::vector<std::uint32_t> joined_with(mesh_.points.size(), 0);
    for (std::uint32_t v = 0; v < joined_with.size(); ++v) ++joined_with[vertices.root(v)];
    for (const auto& [a, b, c] : mesh_.triangles) {
      const IndexedMesh::Triangle triangle{vertices.root(a), vertices.root(b), vertices.root(c)};
      if (!measure::has_vertex_twice(triangle)) joined.triangles.push_back(triangle);
    }
    bool any = false;
    for (const std::uint32_t v :
         vertices_of_several_fans(joined, measure::sides_by_edge(joined.triangles, joined.points.size()))) {
      if (joined_with[v] < 2 || is_apart[place_[v]]) continue;
      is_apart[place_[v]] = any = true;
    }
    return any;
  }

  const IndexedMesh& mesh_;
  const std::vector<std::uint32_t>& place_;
  bool turns_, is_soup_;
  std::vector<IndexedMesh::Triangle> at_;  // the faces, of places
  std::vector<std::uint32_t> collapsing_;  // faces with two corners at one place
  std::vector<Pair> alike_;                // faces on the places of earlier ones, and those
  std::vector<Side> sides_;                // of the others, by place
  detail::UnionFind pieces_;               // faces that hang together
  std::vector<Pair> pairs_;
  std::vector<std::pair<const Side*, const Side*>> ambiguous_;
  std::size_t opposed_ = 0;
};

}  // namespace

Joined pair_and_join(const IndexedMesh& mesh, const std::vector<std::uint32_t>& place,
                     const JoinOptions& options) {
  return Pairing(mesh, place, options).run();
}

}  // namespace whittle::files
