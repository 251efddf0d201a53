/// \file
/// ZIP archives.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace whittle::files {

/// Whether the first bytes say so.
bool is_zip(std::string_view bytes);

/// The files in an archive. What it claims to unpack to is bounded before anything is unpacked, and no file gives more
/// than it claims.
class ZipReader {
 public:
  /// \param bytes  which must outlive this
  /// \throw Fault  damaged, or it claims to unpack to more than 64 MiB and 100 times its size
  explicit ZipReader(std::string_view bytes);

  /// \throw Fault  damaged, packed in another way than ZIP's usual one, encrypted, or not there
  std::string unpacked(std::string_view name) const;

 private:
  struct File {
    std::string_view name;
    std::uint16_t flags, method;
    std::uint32_t checksum;
    std::size_t packed, unpacked, header;
  };
  std::string_view packed_bytes(const File& file) const;

  std::string_view bytes_;
  std::vector<File> files_;
};

/// An archive under construction. The same files give the same bytes.
class ZipWriter {
 public:
  /// \param name  with slashes between folders
  void add(std::string_view name, const std::string& bytes);

  /// The archive. \throw Fault  more than ZIP can hold without its extension for large files: 4 GiB
  std::string take();

 private:
  std::string archive_, directory_;
  std::uint16_t files_ = 0;
  bool is_too_large_ = false;
};

}  // namespace whittle::files
