#include "files/Zip.hh"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>

#include "files/Fault.hh"
#include "files/TextReader.hh"
#include "files/bytes.hh"
#include "files/gzip.hh"

namespace whittle::files {
namespace {

constexpr std::string_view kLocal = "PK\3\4", kCentral = "PK\1\2", kEnd = "PK\5\6";
constexpr std::size_t kLocalBytes = 30, kCentralBytes = 46, kEndBytes = 22, kLongestComment = 65535;
constexpr std::uint64_t kLargest = std::numeric_limits<std::uint32_t>::max();

std::uint16_t short_at(std::string_view bytes, std::size_t at) {
  return load<std::uint16_t>(bytes.data() + at, ByteOrder::little);
}
std::uint32_t long_at(std::string_view bytes, std::size_t at) {
  return load<std::uint32_t>(bytes.data() + at, ByteOrder::little);
}

/// Where the record stands that ends the archive; only a comment may stand behind it.
std::size_t find_end(std::string_view bytes) {
  if (bytes.size() >= kEndBytes) {
    const std::size_t least = bytes.size() - std::min(bytes.size(), kEndBytes + kLongestComment);
    for (std::size_t at = bytes.size() - kEndBytes + 1; at-- > least;)
      if (bytes.substr(at, 4) == kEnd) return at;
  }
  throw Fault("the ZIP archive is cut off");
}

[[noreturn]] void throw_damaged() {
  throw Fault("the ZIP archive is damaged");
}

/// \param claimed  how many bytes that should be; more than these are not unpacked
std::string inflated(std::string_view packed, std::size_t claimed) {
  std::string bytes(claimed, '\0');
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw std::bad_alloc();
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());  // ZIP's own counts have 32 bits, too
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  const int result = inflate(&stream, Z_FINISH);
  const bool is_whole = result == Z_STREAM_END && stream.avail_out == 0;
  inflateEnd(&stream);
  if (!is_whole) throw_damaged();
  return bytes;
}

/// Without a header, as ZIP has it.
std::string deflated(const std::string& bytes) {
  z_stream stream{};
  constexpr int no_header = -MAX_WBITS, usual_memory = 8;
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, no_header, usual_memory, Z_DEFAULT_STRATEGY) !=
      Z_OK)
    throw std::bad_alloc();
  return packed_by(stream, bytes);
}

/// What the local header and the directory say alike of a file.
std::string description(std::string_view name, const std::string& bytes, std::size_t packed) {
  std::string text;
  const std::uint16_t version = 20, names_are_utf8 = 1 << 11, is_deflated = 8, midnight = 0, day = 0x21;
  for (const std::uint16_t value : {version, names_are_utf8, is_deflated, midnight, day})
    append_little(text, value);
  append_little(text, static_cast<std::uint32_t>(
                          crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size())));
  append_little(text, static_cast<std::uint32_t>(packed));
  append_little(text, static_cast<std::uint32_t>(bytes.size()));
  append_little(text, static_cast<std::uint16_t>(name.size()));
  append_little(text, std::uint16_t{0});  // nothing extra
  return text;
}

}  // namespace

bool is_zip(std::string_view bytes) {
  return bytes.substr(0, 4) == kLocal;
}

ZipReader::ZipReader(std::string_view bytes) : bytes_(bytes) {
  const std::size_t end = find_end(bytes);
  const std::size_t files = short_at(bytes, end + 10);
  std::size_t at = long_at(bytes, end + 16);
  std::uint64_t claimed = 0;
  for (std::size_t i = 0; i < files; ++i) {
    if (at > end || end - at < kCentralBytes || bytes.substr(at, 4) != kCentral) throw_damaged();
    const std::size_t name = short_at(bytes, at + 28);
    const std::size_t behind = name + short_at(bytes, at + 30) + short_at(bytes, at + 32);
    if (end - at - kCentralBytes < behind) throw_damaged();
    files_.push_back({bytes.substr(at + kCentralBytes, name), short_at(bytes, at + 8),
                      short_at(bytes, at + 10), long_at(bytes, at + 16), long_at(bytes, at + 20),
                      long_at(bytes, at + 24), long_at(bytes, at + 42)});
    claimed += files_.back().unpacked;
    at += kCentralBytes + behind;
  }
  check_unpacked(claimed, bytes.size());
}

std::string_view ZipReader::packed_bytes(const File& file) const {
  if (file.header > bytes_.size() || bytes_.size() - file.header < kLocalBytes ||
      bytes_.substr(file.header, 4) != kLocal)
    throw_damaged();
  const std::size_t begin =
      file.header + kLocalBytes + short_at(bytes_, file.header + 26) + short_at(bytes_, file.header + 28);
  if (begin > bytes_.size() || bytes_.size() - begin < file.packed) throw_damaged();
  return bytes_.substr(begin, file.packed);
}

std::string ZipReader::unpacked(std::string_view name) const {
  const auto file =
      std::find_if(files_.begin(), files_.end(), [&](const File& one) { return same_word(one.name, name); });
  if (file == files_.end()) throw Fault("the ZIP archive has no file " + in_quotes(name));
  constexpr int encrypted = 1, stored = 0, usual = 8;
  if ((file->flags & encrypted) != 0) throw Fault("the ZIP archive is encrypted");
  if (file->method != stored && file->method != usual)
    throw Fault("the ZIP archive is packed in a way that is not read");
  const std::string_view packed = packed_bytes(*file);
  std::string bytes = file->method == stored ? std::string(packed) : inflated(packed, file->unpacked);
  if (bytes.size() != file->unpacked ||
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) != file->checksum)
    throw_damaged();
  return bytes;
}

void ZipWriter::add(std::string_view name, const std::string& bytes) {
  const std::string packed = deflated(bytes);
  is_too_large_ = is_too_large_ || bytes.size() > kLargest || archive_.size() + packed.size() > kLargest / 2;
  const std::string about = description(name, bytes, packed.size());
  directory_ += kCentral;
  append_little(directory_, std::uint16_t{20});  // the version that made it
  directory_ += about;
  directory_.append(10, '\0');  // no comment, the first disk, no attributes
  append_little(directory_, static_cast<std::uint32_t>(archive_.size()));
  directory_ += name;
  archive_ += kLocal;
  archive_ += about;
  archive_ += name;
  archive_ += packed;
  ++files_;
}

std::string ZipWriter::take() {
  if (is_too_large_) throw Fault("not written: a ZIP archive cannot hold so much");
  const auto begin = static_cast<std::uint32_t>(archive_.size());
  archive_ += directory_;
  archive_ += kEnd;
  append_little(archive_, std::uint32_t{0});  // the first disk
  append_little(archive_, files_);
  append_little(archive_, files_);
  append_little(archive_, static_cast<std::uint32_t>(directory_.size()));
  append_little(archive_, begin);
  append_little(archive_, std::uint16_t{0});  // no comment
  return std::move(archive_);
}

}  // namespace whittle::files
