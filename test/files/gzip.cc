/// \file
/// Files packed by gzip.
#include "files/gzip.hh"

#include "meshes.hh"
#include "samples.hh"

namespace whittle::files {
namespace {

std::string unpacked(const std::string& bytes, std::size_t piece) {
  Gunzip gunzip;
  for (std::size_t i = 0; i < bytes.size(); i += piece) gunzip.add(std::string_view(bytes).substr(i, piece));
  return gunzip.take();
}

TEST_CASE("gzip: what is packed comes back, in pieces of any size") {
  std::string bytes;
  for (int i = 0; i < 100000; ++i) bytes += std::to_string(i * 7919 % 10007);
  const std::string packed = gzipped(bytes);
  CHECK(is_gzip(packed));
  CHECK(packed.size() < bytes.size());
  CHECK(packed == gzipped(bytes));
  for (const std::size_t piece : {std::size_t{1}, std::size_t{1000}, packed.size()})
    CHECK(unpacked(packed, piece) == bytes);
  CHECK(unpacked(gzipped(""), 100).empty());
  // Several parts, as `cat a.gz b.gz` makes them, and zeros behind.
  CHECK(unpacked(packed + gzipped("end") + std::string(512, '\0'), 999) == bytes + "end");
}

TEST_CASE("gzip: every format is read and written packed, told by the name without .gz") {
  const Folder folder;
  const IndexedMesh mesh = rounded(meshes::torus(24, 16));
  for (const Flavour& flavour : flavours()) {
    INFO(flavour.file);
    write_mesh(folder / flavour.file, mesh, flavour.options);
    write_mesh(folder / (flavour.file + ".gz"), mesh, flavour.options);
    CHECK(unpacked(folder.get(flavour.file + ".gz"), 1 << 20) == folder.get(flavour.file));
    const MeshFile file = read_mesh(folder / (flavour.file + ".gz"));
    CHECK(file.report.format == flavour.format + ", gzip");
    CHECK(same_bits<float>(file.mesh, read_mesh(folder / flavour.file).mesh));
  }
  CHECK(extension_of_format("a/b.PLY.GZ") == ".ply");
  CHECK(whole_extension("a/b.PLY.GZ") == ".ply.gz");
  CHECK(extension_of_format("b.obj") == ".obj");
  CHECK(extension_of_format("b.gz").empty());
  CHECK(folder.message([&] { write_mesh(folder / "a.gz", mesh); }).find("a.gz: no extension; known are") ==
        0);
}

TEST_CASE("gzip: damaged and cut off data is an error of one line") {
  const Folder folder;
  const std::string packed = gzipped("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK(folder.read("a.obj", packed).mesh.triangles.size() == 1);  // the content says that it is packed
  CHECK(folder.error("a.obj.gz", packed.substr(0, packed.size() - 5)) ==
        "a.obj.gz: the gzip data is cut off");
  std::string damaged = packed;
  damaged[15] = static_cast<char>(~damaged[15]);
  CHECK(folder.error("a.obj.gz", damaged) == "a.obj.gz: damaged gzip data");
  // A second part that begins wrongly, and anything else but zeros behind.
  std::string second = packed;
  second[0] = 'x';
  for (const std::string& behind : {second, std::string("garbage"), std::string(9, '\0') + packed})
    CHECK(folder.error("a.obj.gz", packed + behind) ==
          "a.obj.gz: damaged gzip data: what follows a part is no other one");
  CHECK(folder.error("a.obj.gz", gzipped("v 0 0\n")) ==
        "a.obj.gz:1: expected a number, found the end of the line");
}

TEST_CASE("gzip: a bomb is refused") {
  const Folder folder;
  const std::string packed = gzipped(std::string(std::size_t{80} << 20, '\n'));
  REQUIRE(packed.size() < 100000);
  CHECK(folder.error("a.obj.gz", packed) ==
        "a.obj.gz: it unpacks to more than 100 times its size, as no mesh does; unpack it first if you trust "
        "it");
}

}  // namespace
}  // namespace whittle::files
