#include "files/ObjPieces.hh"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <utility>

#include "files/FastNumber.hh"
#include "whittle/surface/threads.hh"

namespace whittle::files {
namespace {

bool is_obj_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

struct ObjCounts {
  std::size_t vertices = 0, texture = 0, normals = 0, faces = 0;
};

/// Whole lines of a file.
struct ObjPiece {
  const char* begin = nullptr;
  const char* end = nullptr;
  ObjCounts counts, before;  ///< its own, and those of the pieces before it
  bool has_slashes = false, has_short_lines = false;
  bool any_texture = false, any_normal = false;  ///< its triangles name
  std::size_t triangles = 0;                     ///< of its faces
  std::uint32_t furthest_vertex = 0, furthest_texture = 0,
                furthest_normal = 0;            ///< that its faces name, from 1
  std::vector<ObjLists::Statement> statements;  ///< which count from the begin of the piece
};

enum class ObjLine { vertex, texture, normal, face, other };

const char* skip_blanks(const char* at, const char* end) {
  while (at < end && is_obj_blank(*at)) ++at;
  return at;
}

/// The kind of a line by its first word, and where what follows that begins.
ObjLine line_at(const char*& at, const char* end) {
  const auto is_word = [&](std::size_t length) {
    const bool ends = static_cast<std::size_t>(end - at) > length && is_obj_blank(at[length]);
    if (ends) at += length;
    return ends;
  };
  if (at == end) return ObjLine::other;
  if (*at == 'f') return is_word(1) ? ObjLine::face : ObjLine::other;
  if (*at != 'v') return ObjLine::other;
  if (is_word(1)) return ObjLine::vertex;
  if (at + 1 < end && at[1] == 't' && is_word(2)) return ObjLine::texture;
  if (at + 1 < end && at[1] == 'n' && is_word(2)) return ObjLine::normal;
  return ObjLine::other;
}

const char* line_end(const char* at, const char* end) {
  const void* found = std::memchr(at, '\n', static_cast<std::size_t>(end - at));
  return found == nullptr ? end : static_cast<const char*>(found);
}

void count_lines(ObjPiece& piece) {
  for (const char* at = piece.begin; at < piece.end;) {
    at = skip_blanks(at, piece.end);
    const ObjLine line = line_at(at, piece.end);
    const char* const end = line_end(at, piece.end);
    piece.counts.vertices += line == ObjLine::vertex;
    piece.counts.texture += line == ObjLine::texture;
    piece.counts.normals += line == ObjLine::normal;
    piece.counts.faces += line == ObjLine::face;
    // No room is made for what takes less of the file than any of these does.
    constexpr std::ptrdiff_t shortest = 4;  // " 0 0"
    if (line != ObjLine::other && end - at < shortest) piece.has_short_lines = true;
    if (line == ObjLine::face && !piece.has_slashes)
      piece.has_slashes = std::memchr(at, '/', static_cast<std::size_t>(end - at)) != nullptr;
    at = std::min(end, piece.end - 1) + 1;
  }
}

/// Reads a piece into its places of the lists.
class ObjPieceReader {
 public:
  ObjPieceReader(ObjPiece& piece, ObjLists& lists)
      : piece_(piece),
        lists_(lists),
        at_(piece.begin),
        end_(piece.end),
        vertex_(piece.before.vertices),
        texture_(2 * piece.before.texture),
        normal_(3 * piece.before.normals),
        triangle_(piece.before.faces) {}

  /// \return false: it has something else
  bool read() {
    while (at_ < end_) {
      at_ = skip_blanks(at_, end_);
      if (at_ < end_ && *at_ != '\n' && *at_ != '#' && !read_line()) return false;
      if (at_ < end_ && *at_ == '#') at_ = line_end(at_, end_);
      if (at_ < end_ && *at_++ != '\n') return false;
    }
    piece_.triangles = triangle_ - piece_.before.faces;
    return true;
  }

 private:
  bool read_line() {
    switch (line_at(at_, end_)) {
      case ObjLine::vertex:
        return read_vertex();
      case ObjLine::texture:
        return read_texture();
      case ObjLine::normal:
        normal_ += 3;
        return read_numbers(lists_.normals.data() + normal_ - 3, 3) && ends_line();
      case ObjLine::face:
        return read_face();
      default:
        return read_statement();
    }
  }

  /// Numbers, each behind a blank.
  template <typename Real>
  bool read_numbers(Real* to, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const char* const begin = at_;
      at_ = skip_blanks(at_, end_);
      if (at_ == begin || !read_fast(at_, end_, to[i])) return false;
    }
    return true;
  }

  /// Nothing follows but blanks and a comment.
  bool ends_line() {
    at_ = skip_blanks(at_, end_);
    return at_ == end_ || *at_ == '\n' || *at_ == '#';
  }

  bool read_vertex() { return read_numbers(lists_.points[vertex_++].data(), 3) && ends_line(); }

  /// With a depth behind it, if that is zero.
  bool read_texture() {
    float depth = 0;
    texture_ += 2;
    if (!read_numbers(lists_.texture.data() + texture_ - 2, 2)) return false;
    const char* const behind = at_;
    if (ends_line()) return true;
    at_ = behind;
    return read_numbers(&depth, 1) && depth == 0 && ends_line();
  }

  bool read_index(std::uint32_t& index, std::uint32_t& furthest) {
    std::uint64_t value = 0;
    const char* const begin = at_;
    for (; at_ < end_ && detail_of_numbers::is_digit(*at_) && at_ - begin < 10; ++at_)
      value = 10 * value + static_cast<std::uint64_t>(*at_ - '0');
    if (value == 0 || value >= no_vertex) return false;
    furthest = std::max(furthest, static_cast<std::uint32_t>(value));
    index = static_cast<std::uint32_t>(value) - 1;
    return true;
  }

  /// `v`, `v/t`, `v//n`, `v/t/n`, or with slashes of what is not there.
  bool read_corner(std::size_t k) {
    const char* const begin = at_;
    at_ = skip_blanks(at_, end_);
    if (at_ == begin || !read_index(vertex_of_[k], piece_.furthest_vertex)) return false;
    texture_of_[k] = normal_of_[k] = no_value;
    if (at_ < end_ && *at_ == '/') {
      ++at_;
      if (has_digit() && !read_index(texture_of_[k], piece_.furthest_texture)) return false;
      if (at_ < end_ && *at_ == '/') {
        ++at_;
        if (has_digit() && !read_index(normal_of_[k], piece_.furthest_normal)) return false;
      }
    }
    return true;
  }

  bool has_digit() const { return at_ < end_ && detail_of_numbers::is_digit(*at_); }

  bool read_face() {
    for (std::size_t k = 0; k < 3; ++k)
      if (!read_corner(k)) return false;
    if (!ends_line()) return false;
    ++faces_;
    const auto& [a, b, c] = vertex_of_;
    if (a == b || b == c || c == a) return true;
    if (!lists_.texture_of.empty()) lists_.texture_of[triangle_] = texture_of_;
    if (!lists_.normal_of.empty()) lists_.normal_of[triangle_] = normal_of_;
    piece_.any_texture = piece_.any_texture || names_value(texture_of_);
    piece_.any_normal = piece_.any_normal || names_value(normal_of_);
    lists_.triangles[triangle_++] = vertex_of_;
    return true;
  }

  static bool names_value(const IndexedMesh::Triangle& corners) {
    return corners[0] != no_value || corners[1] != no_value || corners[2] != no_value;
  }

  bool read_statement() {
    const char* const begin = at_;
    while (at_ < end_ && !is_obj_blank(*at_) && *at_ != '\n' && *at_ != '#') ++at_;
    const std::string_view keyword(begin, static_cast<std::size_t>(at_ - begin));
    constexpr std::string_view known[] = {"usemtl", "o", "g", "s", "mtllib"};
    if (std::find(std::begin(known), std::end(known), keyword) == std::end(known)) return false;
    const char* const end = line_end(at_, end_);
    const char* last = end;
    at_ = skip_blanks(at_, end);
    while (last > at_ && is_obj_blank(last[-1])) --last;
    if (last > at_ && last[-1] == '\\') return false;  // the statement goes on
    piece_.statements.push_back(
        {keyword, {at_, static_cast<std::size_t>(last - at_)}, faces_, triangle_ - piece_.before.faces});
    at_ = end;
    return true;
  }

  ObjPiece& piece_;
  ObjLists& lists_;
  const char* at_;
  const char* end_;
  std::size_t vertex_, texture_, normal_, triangle_;  ///< where the next goes
  std::size_t faces_ = 0;
  IndexedMesh::Triangle vertex_of_{}, texture_of_{}, normal_of_{};
};

std::vector<ObjPiece> pieces_of(std::string_view bytes, std::size_t threads) {
  constexpr std::size_t least = 1 << 16;  // bytes that are worth a piece
  const std::size_t n = std::min(4 * threads, bytes.size() / least + 1);
  std::vector<ObjPiece> pieces;
  const char *begin = bytes.data(), *const end = bytes.data() + bytes.size();
  for (std::size_t i = 1; i <= n && begin < end; ++i) {
    const char* last = std::max(begin, bytes.data() + bytes.size() * i / n);
    last = i == n ? end : line_end(last, end);
    if (last < end) ++last;
    pieces.emplace_back();
    pieces.back().begin = std::exchange(begin, last);
    pieces.back().end = last;
  }
  return pieces;
}

/// Makes room in the lists.
ObjCounts make_room(std::vector<ObjPiece>& pieces, ObjLists& lists) {
  ObjCounts all;
  bool has_slashes = false;
  for (ObjPiece& piece : pieces) {
    piece.before = all;
    all.vertices += piece.counts.vertices;
    all.texture += piece.counts.texture;
    all.normals += piece.counts.normals;
    all.faces += piece.counts.faces;
    has_slashes = has_slashes || piece.has_slashes;
  }
  lists.points.resize(all.vertices);
  lists.texture.resize(2 * all.texture);
  lists.normals.resize(3 * all.normals);
  lists.triangles.resize(all.faces);
  if (has_slashes && all.texture > 0) lists.texture_of.resize(all.faces);
  if (has_slashes && all.normals > 0) lists.normal_of.resize(all.faces);
  return all;
}

/// Closes the gaps that faces without a triangle have left.
void close_gaps(const std::vector<ObjPiece>& pieces, std::vector<IndexedMesh::Triangle>& list) {
  if (list.empty()) return;
  std::size_t end = 0;
  for (const ObjPiece& piece : pieces) {
    const auto from = list.begin() + static_cast<std::ptrdiff_t>(piece.before.faces);
    if (end != piece.before.faces)
      std::copy(from, from + static_cast<std::ptrdiff_t>(piece.triangles),
                list.begin() + static_cast<std::ptrdiff_t>(end));
    end += piece.triangles;
  }
  list.resize(end);
}

}  // namespace

bool read_obj_in_pieces(std::string_view bytes, ObjLists& lists) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (bytes.substr(0, mark.size()) == mark) bytes.remove_prefix(mark.size());
  std::vector<ObjPiece> pieces = pieces_of(bytes, detail::thread_count(0));
  detail::Crew crew(std::min(pieces.size(), detail::thread_count(0)));
  crew.each(pieces.size(), [&](std::size_t i) { count_lines(pieces[i]); });
  for (const ObjPiece& piece : pieces)
    if (piece.has_short_lines) return false;
  const ObjCounts all = make_room(pieces, lists);
  if (all.vertices >= no_vertex) return false;
  std::atomic<bool> plain = true;
  crew.each(pieces.size(), [&](std::size_t i) {
    if (plain && !ObjPieceReader(pieces[i], lists).read()) plain = false;
  });
  std::size_t triangles = 0;
  for (ObjPiece& piece : pieces) {
    const bool in_range = piece.furthest_vertex <= all.vertices && piece.furthest_texture <= all.texture &&
                          piece.furthest_normal <= all.normals;
    if (!plain || !in_range) return false;
    for (ObjLists::Statement& statement : piece.statements) {
      statement.faces += piece.before.faces;
      statement.triangles += triangles;
      lists.statements.push_back(statement);
    }
    triangles += piece.triangles;
  }
  lists.faces = all.faces;
  for (auto* list : {&lists.triangles, &lists.texture_of, &lists.normal_of}) close_gaps(pieces, *list);
  const auto has = [&](bool ObjPiece::*any) {
    return std::any_of(pieces.begin(), pieces.end(), [&](const ObjPiece& piece) { return piece.*any; });
  };
  if (!has(&ObjPiece::any_texture)) lists.texture_of.clear();
  if (!has(&ObjPiece::any_normal)) lists.normal_of.clear();
  return true;
}

}  // namespace whittle::files
