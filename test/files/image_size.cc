#include "files/image_size.hh"

#include <fstream>
#include <string>

#include "Folder.hh"
#include "catch.hh"

using namespace whittle;
using namespace std::string_literals;

namespace {

std::string png_of(unsigned width, unsigned height) {
  const auto number = [](unsigned n) {
    return std::string{static_cast<char>(n >> 24), static_cast<char>(n >> 16), static_cast<char>(n >> 8),
                       static_cast<char>(n)};
  };
  return "\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR"s + number(width) + number(height) + "\x08\x02\0\0\0"s;
}

void put_file(const std::filesystem::path& path, const std::string& bytes) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << bytes;
}

std::string little(std::size_t n) {
  return {static_cast<char>(n), static_cast<char>(n >> 8), static_cast<char>(n >> 16),
          static_cast<char>(n >> 24)};
}

/// A binary glTF of this JSON, filled up to a multiple of four, and this binary chunk.
std::string container(std::string json, const std::string& binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  return "glTF" + little(2) + little(28 + json.size() + binary.size()) + little(json.size()) + "JSON" + json +
         little(binary.size()) + "BIN\0"s + binary;
}

}  // namespace

TEST_CASE("the size of an image is in the header of a PNG, and before the frame of a JPEG") {
  const auto png = files::image_size(png_of(640, 70000));
  REQUIRE(png);
  CHECK(png->width == 640);
  CHECK(png->height == 70000);
  // A segment of four bytes, one byte of filling, then a frame of 8 bits, 300 high and 200 wide.
  const std::string jpeg = "\xff\xd8\xff\xe0\0\x04zz\xff\xff\xc2\0\x0b\x08\x01\x2c\0\xc8\x03"s;
  const auto size = files::image_size(jpeg);
  REQUIRE(size);
  CHECK(size->width == 200);
  CHECK(size->height == 300);
}

TEST_CASE("bytes that are no image, cut off, or of no size have none") {
  const std::string jpeg = "\xff\xd8\xff\xc0\0\x0b\x08\x01\x2c\0\xc8\x03"s;
  for (std::size_t n = 0; n < 11; ++n) CHECK_FALSE(files::image_size(jpeg.substr(0, n)));
  for (std::size_t n = 0; n < 24; ++n) CHECK_FALSE(files::image_size(png_of(8, 8).substr(0, n)));
  CHECK_FALSE(files::image_size(png_of(0, 8)));
  CHECK_FALSE(files::image_size("\xff\xd8zz\0\x04zzzzzzzz"s));
  CHECK_FALSE(files::image_size("the fog comes on little cat feet"));
}

TEST_CASE("the image of an OBJ is the one that its material library names, in its folder or below") {
  const scratch::Folder folder;
  const auto obj = folder.path() / "a.obj";
  put_file(folder.path() / "looks/a b.png", png_of(2048, 1024));
  put_file(folder.path() / "looks/a.mtl", "newmtl one\n  map_Kd -s 1 1 1 a.png\n");
  put_file(obj, "# made by hand\nmtllib looks/a.mtl \r\nv 0 0 0\n");
  CHECK_FALSE(files::texture_image_size(obj));
  put_file(folder.path() / "looks/a.png", png_of(512, 256));
  const auto size = files::texture_image_size(obj);
  REQUIRE(size);
  CHECK(size->width == 512);
  CHECK(size->height == 256);
  put_file(folder.path() / "looks/a.mtl", "newmtl one\nmap_Kd a b.png\n");
  CHECK(files::texture_image_size(obj)->width == 2048);
  put_file(folder.path() / "in/a.obj", "mtllib ../looks/a.mtl\n");
  CHECK_FALSE(files::texture_image_size(folder.path() / "in/a.obj"));
  put_file(folder.path() / "b.obj", "mtllib " + (folder.path() / "looks/a.mtl").string() + "\n");
  CHECK_FALSE(files::texture_image_size(folder.path() / "b.obj"));
  CHECK_FALSE(files::texture_image_size(folder.path() / "none.obj"));
  CHECK_FALSE(files::texture_image_size("-"));
}

TEST_CASE("the image of a GLB is the one of its first material, in its binary chunk or beside it") {
  const scratch::Folder folder;
  const auto glb = folder.path() / "a.glb";
  const std::string head =
      R"({"asset":{"version":"2.0"},"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":1}}}],)"
      R"("textures":[{"source":0},{"source":1}],"images":[{"uri":"none.png"},)";
  put_file(
      glb,
      container(head + R"({"bufferView":0}],"bufferViews":[{"buffer":0,"byteOffset":5,"byteLength":40}]})",
                "zzzzz" + png_of(4096, 32)));
  const auto inside = files::texture_image_size(glb);
  REQUIRE(inside);
  CHECK(inside->width == 4096);
  CHECK(inside->height == 32);
  put_file(glb, container(head + R"({"uri":"b.png"}]})", ""));
  CHECK_FALSE(files::texture_image_size(glb));
  put_file(folder.path() / "b.png", png_of(16, 64));
  CHECK(files::texture_image_size(glb)->height == 64);
  for (const std::string json : {"{}", "[", R"({"materials":[{"pbrMetallicRoughness":7}]})"}) {
    put_file(glb, container(json, ""));
    CHECK_FALSE(files::texture_image_size(glb));
  }
}
