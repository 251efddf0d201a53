#include "experiment/Model.hh"

#include "Folder.hh"
#include "experiment/GeneratedMesh.hh"
#include "files/MeshFile.hh"

using namespace whittle;
namespace fs = std::filesystem;

TEST_CASE("without the bunny the model is the stand-in, and says so whatever it is called") {
  const scratch::Folder empty;
  const auto model = bench::load_model(std::nullopt, empty.path());
  CHECK(model.kind == bench::ModelKind::generated);
  CHECK(model.label == "generated closed mesh, not the bunny");
  CHECK(model.file.empty());
  REQUIRE(model.notes.size() == 1);
  CHECK_THAT(model.notes[0], Catch::Contains("not the bunny"));
  CHECK(bench::load_model(std::nullopt, empty.path(), "bunny").label ==
        "bunny (generated closed mesh, not the bunny)");
}

TEST_CASE("the bunny is taken from the cache") {
  const scratch::Folder cache;
  files::write_mesh(cache.path() / "bunny.ply", bench::generated_mesh(3));
  const auto model = bench::load_model(std::nullopt, cache.path());
  CHECK(model.kind == bench::ModelKind::bunny);
  CHECK(model.label == "Stanford bunny");
  CHECK(model.file == "bunny.ply");
  CHECK(model.mesh.triangles.size() == 180);
  CHECK(model.notes.empty());
}

TEST_CASE("a file of other units is noted, and only its name is kept of its path") {
  const scratch::Folder folder;
  files::write_mesh(folder.path() / "ball.obj", bench::generated_mesh(3, 1.0));
  const auto model = bench::load_model(folder.path() / "ball.obj", folder.path());
  CHECK(model.kind == bench::ModelKind::file);
  CHECK(model.file == "ball.obj");
  CHECK(model.label == "ball.obj");
  CHECK(model.mean_edge == Approx(1.0));
  REQUIRE(model.notes.size() == 1);
  CHECK_THAT(model.notes[0], Catch::Contains("mean edge"));
  CHECK(bench::load_model(folder.path() / "ball.obj", folder.path(), "a ball").label == "a ball");
}

TEST_CASE("a missing file is an error") {
  CHECK_THROWS_AS(bench::load_model("no/such/file.obj", "."), files::FileError);
}
