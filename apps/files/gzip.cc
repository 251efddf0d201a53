#include "files/gzip.hh"

#include <algorithm>
#include <limits>
#include <new>

#include "files/Fault.hh"
#include "files/TextReader.hh"

namespace whittle::files {
namespace {

constexpr int kGzip = 16 + MAX_WBITS;  // the header of gzip, not of zlib
constexpr std::size_t kLargestRatio = 100, kAlwaysAllowed = std::size_t{64} << 20;

Bytef* as_bytes(const char* text) {
  return reinterpret_cast<Bytef*>(const_cast<char*>(text));  // zlib's interface is older than const
}

/// A part of a size that zlib can count.
uInt portion(std::size_t size) {
  return static_cast<uInt>(std::min<std::size_t>(size, std::numeric_limits<uInt>::max()));
}

}  // namespace

bool is_gzip(std::string_view bytes) {
  return bytes.substr(0, 3) == "\x1f\x8b\x08";
}

bool is_gzip_name(const std::filesystem::path& path) {
  return same_word(path.extension().string(), ".gz");
}

Gunzip::Gunzip() {
  if (inflateInit2(&stream_, kGzip) != Z_OK) throw std::bad_alloc();
}

Gunzip::~Gunzip() {
  inflateEnd(&stream_);
}

void Gunzip::grow() {
  constexpr std::size_t first = 1 << 16;
  const std::size_t most = std::max(kAlwaysAllowed, kLargestRatio * packed_);
  check_unpacked(used_ + (used_ >= most ? 1 : 0), packed_);
  bytes_.resize(std::min(most, std::max(first, 2 * bytes_.size())));
}

void Gunzip::add(std::string_view packed) {
  packed_ += packed.size();
  while (!packed.empty()) {
    if (!is_part_open_) {
      is_over_ = is_over_ || packed[0] == '\0';  // some programs fill the last block with zeros
      if (is_over_ && packed.find_first_not_of('\0') == std::string_view::npos) return;
      if (is_over_ || packed[0] != '\x1f')
        throw Fault("damaged gzip data: what follows a part is no other one");
      inflateReset(&stream_);
      is_part_open_ = true;
    }
    if (used_ == bytes_.size()) grow();
    stream_.next_in = as_bytes(packed.data());
    stream_.avail_in = portion(packed.size());
    stream_.next_out = as_bytes(bytes_.data() + used_);
    const uInt room = stream_.avail_out = portion(bytes_.size() - used_);
    const uInt offered = stream_.avail_in;
    const int result = inflate(&stream_, Z_NO_FLUSH);
    used_ += room - stream_.avail_out;
    packed.remove_prefix(offered - stream_.avail_in);
    if (result == Z_STREAM_END)
      is_part_open_ = false;
    else if (result == Z_MEM_ERROR)
      throw std::bad_alloc();
    else if (result != Z_OK && result != Z_BUF_ERROR)
      throw Fault("damaged gzip data");
  }
}

std::string Gunzip::take() {
  if (is_part_open_) throw Fault("the gzip data is cut off");
  bytes_.resize(used_);
  return std::move(bytes_);
}

void check_unpacked(std::uint64_t unpacked, std::size_t packed) {
  if (unpacked > kAlwaysAllowed && unpacked / kLargestRatio > packed)
    throw Fault("it unpacks to more than " + std::to_string(kLargestRatio) +
                " times its size, as no mesh does; unpack it first if you trust it");
}

std::string packed_by(z_stream& stream, const std::string& bytes) {
  std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  std::size_t read = 0, written = 0;
  int result = Z_OK;
  while (result == Z_OK) {
    const uInt in = stream.avail_in = portion(bytes.size() - read);
    const uInt out = stream.avail_out = portion(packed.size() - written);
    stream.next_in = as_bytes(bytes.data() + read);
    stream.next_out = as_bytes(packed.data() + written);
    result = deflate(&stream, read + in == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
    read += in - stream.avail_in;
    written += out - stream.avail_out;
  }
  deflateEnd(&stream);
  if (result != Z_STREAM_END) throw Fault("not written: zlib cannot pack it");
  packed.resize(written);
  return packed;
}

std::string gzipped(const std::string& bytes) {
  z_stream stream{};
  constexpr int usual_memory = 8;
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzip, usual_memory, Z_DEFAULT_STRATEGY) !=
      Z_OK)
    throw std::bad_alloc();
  return packed_by(stream, bytes);
}

}  // namespace whittle::files
