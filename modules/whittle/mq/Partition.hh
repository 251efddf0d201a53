/// \file
/// A mesh in parts, for several threads.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/mq/FaceNotes.hh"

namespace whittle::mq {

/// The vertices in parts by their numbers, equally many in each. A face is in the part of its vertices if all
/// three are in the same, else in none. The parts do not depend on the number of threads.
class Partition {
 public:
  Partition() = default;

  /// \param table  with its faces by their smallest vertex.
  explicit Partition(const CornerTable& table) {
    // Larger parts leave fewer edges between them, smaller ones fit the cache; four occupy several threads.
    constexpr std::size_t kPartSize = 16384, kLeastSize = 1024, kSome = 4;
    const std::size_t n = table.n_vertices(), some = std::clamp<std::size_t>(n / kLeastSize, 1, kSome);
    size_ = static_cast<PartNumber>(std::clamp<std::size_t>(n / kPartSize, some, 0xffff));
    parts_per_vertex_ = (std::uint64_t{size_} << 32) / std::max<std::size_t>(n, 1);
    for (std::uint64_t part = 0; part <= size_; ++part) {
      const std::uint64_t v = ((part << 32) + parts_per_vertex_ - 1) / parts_per_vertex_;
      first_vertex_.push_back(static_cast<std::uint32_t>(part < size_ ? v : n));
      const auto before = [](const CornerTable::Face& face, std::uint32_t vertex) {
        return *std::min_element(face.vertex.begin(), face.vertex.end()) < vertex;
      };
      const auto& faces = table.faces();
      first_face_.push_back(static_cast<std::size_t>(
          std::lower_bound(faces.begin(), faces.end(), first_vertex_.back(), before) - faces.begin()));
    }
  }

  PartNumber size() const { return size_; }
  PartNumber part_of(std::uint32_t v) const {
    return static_cast<PartNumber>((v * parts_per_vertex_ >> 32) + 1);
  }
  PartNumber part_of(const std::array<std::uint32_t, 3>& t) const {
    const PartNumber part = part_of(t[0]);
    return part == part_of(t[1]) && part == part_of(t[2]) ? part : kNoPart;
  }

  /// The first vertex of a part 1..size(); of size() + 1, the number of vertices.
  std::uint32_t first_vertex(std::size_t part) const { return first_vertex_[part - 1]; }
  /// The first face whose smallest vertex is in a part 1..size(); of size() + 1, the number of faces.
  std::size_t first_face(std::size_t part) const { return first_face_[part - 1]; }

 private:
  PartNumber size_ = 0;
  std::uint64_t parts_per_vertex_ = 1;  // times 2^32
  std::vector<std::uint32_t> first_vertex_;
  std::vector<std::size_t> first_face_;
};

}  // namespace whittle::mq
