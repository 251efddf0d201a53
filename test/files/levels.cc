/// \file
/// Levels of detail in one GLB.
#include "gltf_samples.hh"
#include "meshes.hh"

namespace whittle::files {
namespace {

TEST_CASE("write_glb_levels: the first level is the scene, the others hang on it") {
  const Folder folder;
  const std::vector<Level> levels{{meshes::torus(24, 16), {}, {}, 0},
                                  {meshes::torus(12, 8), {}, {}, 0.01},
                                  {square(), {square_normals()}, {}, 1}};
  const WriteReport report = write_glb_levels(folder / "a.glb", levels);
  CHECK(report.notes().empty());

  const Json json = json_of(folder.get("a.glb"));
  CHECK(json["extensionsUsed"] == Json{"MSFT_lod"});
  CHECK(json["scenes"][0]["nodes"] == Json{0});
  CHECK(json["nodes"][0]["extensions"]["MSFT_lod"]["ids"] == Json{1, 2});
  CHECK(json["nodes"][0]["extras"]["error"] == 0);
  CHECK(json["nodes"][2]["extras"]["error"] == 1);
  const Json coverage = json["nodes"][0]["extras"]["MSFT_screencoverage"];
  REQUIRE(coverage.size() == 3);
  CHECK(coverage[0].get<double>() > coverage[1].get<double>());
  CHECK(coverage[0].get<double>() < 1);
  CHECK(coverage[2] == 0);

  const MeshFile first = read_mesh(folder / "a.glb");
  CHECK(same_bits<float>(first.mesh, levels[0].mesh));
  CHECK(first.report.ignored == Names{"2 coarser levels of detail"});
}

TEST_CASE("write_glb_levels: no coverage where errors do not grow, no extension for one level") {
  const Folder folder;
  write_glb_levels(folder / "a.glb", {{square(), {}, {}, 0}, {square(), {}, {}, 0}});
  CHECK_FALSE(json_of(folder.get("a.glb"))["nodes"][0]["extras"].contains("MSFT_screencoverage"));
  CHECK(read_mesh(folder / "a.glb").report.ignored.front() == "1 coarser level of detail");
  write_glb_levels(folder / "b.glb", {{square(), {}, {}, 0}});
  CHECK_FALSE(json_of(folder.get("b.glb")).contains("extensionsUsed"));
  CHECK(read_mesh(folder / "b.glb").report.notes().empty());
}

TEST_CASE("write_glb_levels refuses what write_mesh would") {
  const Folder folder;
  const auto error = [&](const std::vector<Level>& levels) {
    return folder.message([&] { write_glb_levels(folder / "a.glb", levels); });
  };
  CHECK(error({}) == "a.glb: not written: there is no level of detail");
  CHECK(error({{square(), {}, {}, NAN}}) == "a.glb: not written: an error that is not finite");
  IndexedMesh bad = square();
  bad.triangles.push_back({0, 1, 9});
  CHECK(error({{square(), {}, {}, 0}, {bad, {}, {}, 1}}) ==
        "a.glb: not written: a triangle names a vertex that is not there");
  CHECK(folder.entries() == 0);
}

}  // namespace
}  // namespace whittle::files
