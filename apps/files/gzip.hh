/// \file
/// Files packed by gzip.
#pragma once

#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace whittle::files {

/// Whether the first bytes say so.
bool is_gzip(std::string_view bytes);

/// Whether the name ends in ".gz", in any case of letters.
bool is_gzip_name(const std::filesystem::path& path);

/// Unpacks piece by piece, so that the packed file is never in memory as a whole. Of several parts one behind the other
/// each is unpacked; behind the last one there may be zeros.
class Gunzip {
 public:
  Gunzip();
  ~Gunzip();
  Gunzip(const Gunzip&) = delete;
  Gunzip& operator=(const Gunzip&) = delete;

  /// \throw Fault  damaged; or it becomes more than 64 MiB and 100 times what was packed, as no mesh does
  void add(std::string_view packed);

  /// What was packed. \throw Fault  it is cut off
  std::string take();

 private:
  void grow();

  z_stream stream_{};
  std::string bytes_;
  std::size_t used_ = 0, packed_ = 0;
  bool is_part_open_ = true;  ///< the end of a part has not come yet
  bool is_over_ = false;      ///< zeros have come, so no further part may
};

/// The same bytes give the same file. \throw Fault
std::string gzipped(const std::string& bytes);

/// What a stream that zlib has been told how to pack makes of the bytes; ends the stream. \throw Fault
std::string packed_by(z_stream& stream, const std::string& bytes);

/// \throw Fault  `unpacked` bytes are more than 64 MiB and 100 times `packed`
void check_unpacked(std::uint64_t unpacked, std::size_t packed);

}  // namespace whittle::files
