#include "files/image_size.hh"

#include <fstream>
#include <string>

#include "Folder.hh"
#include "catch.hh"
#include "files/MeshFile.hh"

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

TEST_CASE("the size of a texture is that of the first image of a base colour, in a library or in a GLB") {
  const scratch::Folder folder;
  const auto size_of = [&](const std::string& name) {
    return files::texture_image_size(files::read_mesh(folder.path() / name).parts);
  };
  put_file(folder.path() / "looks/a b.png", png_of(2048, 1024));
  put_file(folder.path() / "looks/a.mtl", "newmtl one\n  map_Kd -s 1 1 1 a.png\n");
  put_file(folder.path() / "a.obj", "# made by hand\nmtllib looks/a.mtl \r\nusemtl one\nv 0 0 0\n");
  CHECK_FALSE(size_of("a.obj"));
  put_file(folder.path() / "looks/a.png", png_of(512, 256));
  const auto size = size_of("a.obj");
  REQUIRE(size);
  CHECK(size->width == 512);
  CHECK(size->height == 256);
  put_file(folder.path() / "looks/a.mtl", "newmtl one\nmap_Kd a b.png\n");
  CHECK(size_of("a.obj")->width == 2048);

  const std::string json =
      R"({"asset":{"version":"2.0"},"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],)"
      R"("textures":[{"source":0}],"images":[{"bufferView":0}],"buffers":[{"byteLength":45}],)"
      R"("bufferViews":[{"buffer":0,"byteOffset":5,"byteLength":40}]})";
  put_file(folder.path() / "a.glb", container(json, "zzzzz" + png_of(4096, 32) + std::string(20, 'z')));
  REQUIRE(size_of("a.glb"));
  CHECK(size_of("a.glb")->width == 4096);
}

TEST_CASE("the size of a texture counts how often coordinates go across it") {
  files::Parts parts;
  CHECK_FALSE(files::texture_image_size(parts));
  parts.images.push_back({"a", {}, png_of(64, 32)});
  parts.materials.resize(2);
  parts.materials[1].image = 0;
  parts.materials[1].texture_scale = {2, 0.5};
  CHECK(files::texture_image_size(parts)->width == 128);
  CHECK(files::texture_image_size(parts)->height == 16);
}
