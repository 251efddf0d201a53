#include "files/OmChunks.hh"

#include "files/Fault.hh"
#include "files/bytes.hh"

namespace whittle::files::om {
namespace {

constexpr std::uint8_t newest_version = version(2, 2);
constexpr std::size_t most_chunks = 1000;  // each takes more memory than the two bytes that an empty one has

template <typename T>
T number(std::string_view data, std::size_t index) {
  return load<T>(data.data() + index * sizeof(T), ByteOrder::little);
}

}  // namespace

double Chunk::real(std::size_t index) const {
  if (!header.is_float) return static_cast<double>(integer(index));
  switch (header.size) {
    case 0:
      return number<float>(data, index);
    case 1:
      return number<double>(data, index);
    default:
      throw Fault("floats of more than 64 bits are not supported");
  }
}

std::int64_t Chunk::integer(std::size_t index) const {
  switch (header.size) {
    case 0:
      return header.is_signed ? std::int64_t{number<std::int8_t>(data, index)}
                              : std::int64_t{number<std::uint8_t>(data, index)};
    case 1:
      return header.is_signed ? std::int64_t{number<std::int16_t>(data, index)}
                              : std::int64_t{number<std::uint16_t>(data, index)};
    case 2:
      return header.is_signed ? std::int64_t{number<std::int32_t>(data, index)}
                              : std::int64_t{number<std::uint32_t>(data, index)};
    default:
      return number<std::int64_t>(data, index);
  }
}

Chunks::Chunks(std::string_view bytes) : rest_(bytes) {
  const std::string_view head = take(header_bytes);
  if (head.substr(0, 2) != "OM") throw Fault("not an OM file: it does not begin with 'OM'");
  mesh_type_ = head[2];
  if (std::string_view("TQP").find(mesh_type_) == std::string_view::npos)
    throw Fault("unknown type of mesh " + in_quotes(head.substr(2, 1)));
  version_ = static_cast<std::uint8_t>(head[3]);
  if (version_ > newest_version)
    throw Fault("OM version " + std::to_string(major_of(version_)) + "." +
                std::to_string(minor_of(version_)) + " is not known");
  vertices_ = number<std::uint32_t>(head, 1);
  faces_ = number<std::uint32_t>(head, 2);
  edges_ = number<std::uint32_t>(head, 3);

  for (;;) {
    // Files before version 2 just end.
    if (rest_.empty() && version_ < om::version(2, 0)) return;
    const auto header = ChunkHeader::unpack(number<std::uint16_t>(take(chunk_header_bytes), 0));
    if (header.entity == Entity::end) return;
    if (chunks_.size() == most_chunks)
      throw Fault("the file has more than " + std::to_string(most_chunks) + " chunks");
    read_chunk(header);
  }
}

void Chunks::read_chunk(ChunkHeader header) {
  Chunk chunk;
  chunk.header = header;
  if (header.named) chunk.name = read_name();
  if (header.type == Type::custom) {
    if (version_ > om::version(2, 0)) chunk.type_name = read_name();
    chunk.data = take(number<std::uint32_t>(take(4), 0));
  } else {
    if (find(header.entity, header.type) != nullptr) throw Fault("a second chunk of the same kind");
    chunk.data = take(data_bytes(header));
  }
  chunks_.push_back(std::move(chunk));
}

std::string Chunks::read_name() {
  const auto length = static_cast<unsigned char>(take(1)[0]);
  return std::string(take(length));
}

std::size_t Chunks::data_bytes(const ChunkHeader& header) {
  if (header.type > Type::topology || header.type == static_cast<Type>(5))
    throw Fault("a chunk of unknown type");
  if (header.entity == Entity::face && header.type == Type::topology && version_ < om::version(2, 0))
    return face_list_bytes(header);
  const std::size_t count = count_of(header.entity);
  if (header.type == Type::status) return count * status_bytes;
  return count * header.dimensions * header.number_bytes();
}

/// Before version 2 faces name their vertices; polygons say how many they are.
std::size_t Chunks::face_list_bytes(const ChunkHeader& header) const {
  if (mesh_type_ != 'P') return faces_ * (mesh_type_ == 'T' ? 3 : 4) * header.number_bytes();
  std::size_t at = 0;
  for (std::size_t face = 0; face < faces_; ++face) {
    if (rest_.size() < at + 2) throw Fault("the file is cut off");
    at += 2 + header.number_bytes() * load<std::uint16_t>(rest_.data() + at, ByteOrder::little);
  }
  return at;
}

std::size_t Chunks::count_of(Entity entity) const {
  switch (entity) {
    case Entity::vertex:
      return vertices_;
    case Entity::mesh:
      return 1;
    case Entity::face:
      return faces_;
    case Entity::edge:
      return edges_;
    case Entity::halfedge:
      return halfedges();
    default:
      throw Fault("a chunk of neither vertices nor faces nor edges");
  }
}

std::string_view Chunks::take(std::size_t bytes) {
  if (bytes > rest_.size()) throw Fault("the file is cut off");
  const std::string_view taken = rest_.substr(0, bytes);
  rest_.remove_prefix(bytes);
  return taken;
}

const Chunk* Chunks::find(Entity entity, Type type) const {
  for (const Chunk& chunk : chunks_)
    if (chunk.header.entity == entity && chunk.header.type == type) return &chunk;
  return nullptr;
}

}  // namespace whittle::files::om
