#include "render/Image.hh"

#include <png.h>

#include "render/GlObject.hh"

namespace whittle::render {
namespace {

[[noreturn]] void fail(png_structp, png_const_charp message) {
  throw RenderError(std::string("PNG: ") + message);
}

void ignore_warning(png_structp, png_const_charp) {}

void append(png_structp writer, png_bytep data, png_size_t size) {
  static_cast<std::string*>(png_get_io_ptr(writer))->append(reinterpret_cast<const char*>(data), size);
}

void flush_nothing(png_structp) {}

/// libpng's pair of write structures.
class Writer {
 public:
  Writer() : writer_(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore_warning)) {
    if (writer_ != nullptr) info_ = png_create_info_struct(writer_);
    if (info_ == nullptr) {
      png_destroy_write_struct(&writer_, nullptr);
      throw RenderError("PNG: out of memory");
    }
  }
  ~Writer() { png_destroy_write_struct(&writer_, &info_); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  png_structp writer() const { return writer_; }
  png_infop info() const { return info_; }

 private:
  png_structp writer_ = nullptr;
  png_infop info_ = nullptr;
};

}  // namespace

std::string encode_png(const Image& image, const std::string& caption) {
  std::string bytes;
  const Writer png;
  png_set_write_fn(png.writer(), &bytes, append, flush_nothing);
  png_set_IHDR(png.writer(), png.info(), static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);

  std::string key = "Description", text = caption;
  if (!caption.empty()) {
    png_text chunk{};
    chunk.compression = PNG_TEXT_COMPRESSION_NONE;
    chunk.key = key.data();
    chunk.text = text.data();
    png_set_text(png.writer(), png.info(), &chunk, 1);
  }
  png_write_info(png.writer(), png.info());
  const std::size_t stride = 4 * static_cast<std::size_t>(image.width);
  for (int y = 0; y < image.height; ++y) png_write_row(png.writer(), image.rgba.data() + y * stride);
  png_write_end(png.writer(), nullptr);
  return bytes;
}

}  // namespace whittle::render
