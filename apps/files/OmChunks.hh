/// \file
/// An OM file taken apart into its chunks, with every size checked.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "files/om_format.hh"

namespace whittle::files::om {

struct Chunk {
  ChunkHeader header;
  std::string name;       ///< of a property
  std::string type_name;  ///< of a property, from version 2.1 on: "float"
  std::string_view data;

  /// A number of the chunk, counted from its begin.
  /// \pre index < data.size() / header.number_bytes()
  /// \{
  double real(std::size_t index) const;
  std::int64_t integer(std::size_t index) const;
  /// \}
};

class Chunks {
 public:
  /// \throw Fault  damaged, cut off, or of a version that is not known
  explicit Chunks(std::string_view bytes);

  char mesh_type() const { return mesh_type_; }  ///< 'T'riangles, 'Q'uads or 'P'olygons
  std::uint8_t version() const { return version_; }
  std::size_t vertices() const { return vertices_; }
  std::size_t faces() const { return faces_; }
  std::size_t halfedges() const { return 2 * edges_; }
  std::size_t bytes_behind() const { return rest_.size(); }

  const std::vector<Chunk>& all() const { return chunks_; }

  /// Null if there is none.
  const Chunk* find(Entity entity, Type type) const;

 private:
  void read_chunk(ChunkHeader header);
  std::string read_name();
  std::size_t data_bytes(const ChunkHeader& header);
  std::size_t face_list_bytes(const ChunkHeader& header) const;
  std::size_t count_of(Entity entity) const;
  std::string_view take(std::size_t bytes);

  std::string_view rest_;
  char mesh_type_ = 'T';
  std::uint8_t version_ = 0;
  std::size_t vertices_ = 0, faces_ = 0, edges_ = 0;
  std::vector<Chunk> chunks_;
};

}  // namespace whittle::files::om
