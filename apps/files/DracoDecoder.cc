#include "files/DracoDecoder.hh"

#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>

#include <cstdint>
#include <string>
#include <type_traits>

#include "files/Fault.hh"

namespace whittle::files {
namespace {

[[noreturn]] void throw_damaged_draco() {
  throw Fault("its data are damaged: a part packed by KHR_draco_mesh_compression");
}

/// \throw Fault  there is not so much left
void take(std::size_t& left, std::uint64_t count, std::size_t bytes_each) {
  if (count > left / bytes_each) throw Fault("the scene is too many times as large as the file");
  left -= static_cast<std::size_t>(count) * bytes_each;
}

/// A decoder of Draco that looks at each count before the library makes room for it.
template <typename Base>
class Bounded : public Base {
 public:
  explicit Bounded(DracoLimits& limits) : limits_(limits) {}

 protected:
  bool DecodeConnectivity() override {
    draco::DecoderBuffer ahead = *this->buffer();  // a place in the bytes, not the bytes
    std::uint32_t first = 0, second = 0;
    if (!draco::DecodeVarint(&first, &ahead) || !draco::DecodeVarint(&second, &ahead)) return false;
    if constexpr (std::is_same_v<Base, draco::MeshEdgebreakerDecoder>) {
      // Vertices and faces, then how many attributes have seams of their own: each gets a corner table.
      std::uint8_t seamed = 0;
      if (!ahead.Decode(&seamed)) return false;
      constexpr std::size_t table_bytes = 64, seam_bytes = 48;
      std::size_t working = limits_.working_bytes;
      take(working, second, table_bytes + seam_bytes * seamed);
      take_faces(second);
    } else {
      take_faces(first);
    }
    return Base::DecodeConnectivity();
  }

  /// Here all attributes are known, and none has values.
  bool DecodeAllAttributes() override {
    const draco::PointCloud& points = *this->point_cloud();
    for (int i = 0; i < points.num_attributes(); ++i) {
      const draco::PointAttribute& attribute = *points.attribute(i);
      // While they are unpacked they are integers; and each point has the number of its value.
      const std::size_t bytes = static_cast<std::size_t>(attribute.byte_stride()) +
                                sizeof(std::int32_t) * attribute.num_components() + sizeof(std::uint32_t);
      take(limits_.result_bytes, points.num_points(), bytes);
    }
    return Base::DecodeAllAttributes();
  }

 private:
  void take_faces(std::uint32_t faces) { take(limits_.result_bytes, faces, 3 * sizeof(std::uint32_t)); }

  DracoLimits& limits_;
};

template <typename Base>
std::unique_ptr<draco::Mesh> decoded_by(draco::DecoderBuffer& buffer, DracoLimits& limits) {
  auto mesh = std::make_unique<draco::Mesh>();
  const draco::DecoderOptions options;
  Bounded<Base> decoder(limits);
  if (!decoder.Decode(options, &buffer, mesh.get()).ok()) throw_damaged_draco();
  return mesh;
}

}  // namespace

std::unique_ptr<draco::Mesh> decode_draco(std::string_view bytes, DracoLimits& limits) {
  draco::DecoderBuffer buffer, ahead;
  buffer.Init(bytes.data(), bytes.size());
  ahead.Init(bytes.data(), bytes.size());
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&ahead, &header).ok()) throw_damaged_draco();
  if (header.version_major != 2 || header.version_minor != 2)
    throw Fault("a part packed by version " + std::to_string(header.version_major) + "." +
                std::to_string(header.version_minor) + " of Draco's format; glTF has version 2.2");
  if (header.encoder_type != draco::TRIANGULAR_MESH) throw_damaged_draco();
  switch (header.encoder_method) {
    case draco::MESH_EDGEBREAKER_ENCODING:
      return decoded_by<draco::MeshEdgebreakerDecoder>(buffer, limits);
    case draco::MESH_SEQUENTIAL_ENCODING:
      return decoded_by<draco::MeshSequentialDecoder>(buffer, limits);
    default:
      throw_damaged_draco();
  }
}

}  // namespace whittle::files
