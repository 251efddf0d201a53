/// \file
/// Every module in every decimater of OpenMesh, alone and beside every stock binary module.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Tools/Decimater/McDecimaterT.hh>
#include <OpenMesh/Tools/Decimater/MixedDecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModAspectRatioT.hh>
#include <OpenMesh/Tools/Decimater/ModEdgeLengthT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModIndependentSetsT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalDeviationT.hh>
#include <OpenMesh/Tools/Decimater/ModRoundnessT.hh>

#include "OpenMeshFixture.hh"
#include "measure/MeshFacts.hh"
#include "whittle/ModCircumcenterT.hh"
#include "whittle/ModFaceAngleT.hh"
#include "whittle/ModFassT.hh"
#include "whittle/ModSphereScanT.hh"
#include "whittle/ModVertexDistanceT.hh"
#include "whittle/ModVtdT.hh"

using namespace whittle;
using fixture::Mesh;
namespace om = OpenMesh::Decimater;

namespace {

template <typename Module, typename D>
Module& add(D& decimater) {
  typename Module::Handle handle;
  decimater.add(handle);
  return decimater.module(handle);
}

const bool kQuiet = (omlog().disable(), true);  // McDecimaterT prints when it gives up

constexpr int kModules = 6;
template <typename D>
PlannedModule& add_module(D& decimater, int which) {
  switch (which) {
    case 0:
      return add<ModCircumcenterT<Mesh>>(decimater);
    case 1:
      return add<ModFaceAngleT<Mesh>>(decimater);
    case 2: {
      auto& module = add<ModVertexDistanceT<Mesh>>(decimater);
      module.set_max_distance(0.12);
      return module;
    }
    case 3: {
      auto& module = add<ModSphereScanT<Mesh>>(decimater);
      module.set_radius(0.12);
      return module;
    }
    case 4: {
      auto& module = add<ModVtdT<Mesh>>(decimater);
      module.set_max_distance(0.12);
      return module;
    }
    default: {
      auto& module = add<ModFassT<Mesh>>(decimater);
      module.set_radius(0.12);
      return module;
    }
  }
}

constexpr int kConstraints = 8, kRoundness = 6;
template <typename D>
void add_constraint(D& decimater, int which) {
  switch (which) {
    case 0:
      return;
    case 1:
      add<om::ModNormalFlippingT<Mesh>>(decimater).set_max_normal_deviation(40);
      return;
    case 2:
      add<om::ModNormalDeviationT<Mesh>>(decimater).set_normal_deviation(120);
      return;
    case 3:
      add<om::ModAspectRatioT<Mesh>>(decimater).set_aspect_ratio(12);
      return;
    case 4:
      add<om::ModEdgeLengthT<Mesh>>(decimater).set_edge_length(0.2f);
      return;
    case 5:
      add<om::ModHausdorffT<Mesh>>(decimater).set_tolerance(0.05f);
      return;
    case 6:
      add<om::ModRoundnessT<Mesh>>(decimater).set_min_roundness(1e-4f, true);
      return;
    default:
      add<om::ModIndependentSetsT<Mesh>>(decimater);
      return;
  }
}

/// MixedDecimaterT needs the share of the work that McDecimaterT does first.
constexpr float kMcPart = 0.5f;
template <typename D>
constexpr bool is_mixed = std::is_same_v<D, om::MixedDecimaterT<Mesh>>;

Mesh start() {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::shaken(meshes::torus(30, 18), 0.005, 2));
  mesh.request_face_normals();
  mesh.update_face_normals();
  mesh.request_vertex_status();
  mesh.request_halfedge_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  return mesh;
}

std::size_t n_living(const Mesh& mesh) {
  std::size_t n = 0;
  for (const auto v : mesh.all_vertices()) n += !mesh.status(v).deleted();
  return n;
}

void check_sound(const Mesh& mesh) {
  const auto flat = to_indexed(mesh);
  IndexedMesh out;
  for (const auto& p : flat.points) out.points.push_back(p.cast<double>());
  out.triangles = flat.triangles;
  const auto facts = measure::facts(out);
  CHECK(facts.closed());
  CHECK(facts.euler_characteristic == 0);
  CHECK(facts.duplicate_faces == 0);
}

template <typename D>
void check_all() {
  for (int module = 0; module < kModules; ++module)
    for (int constraint = 0; constraint < kConstraints; ++constraint) {
      INFO("module " << module << ", constraint " << constraint);
      Mesh mesh = start();
      const std::size_t before = n_living(mesh);
      D decimater(mesh);
      PlannedModule& planned = add_module(decimater, module);
      add_constraint(decimater, constraint);
      REQUIRE((kQuiet && decimater.initialize()));
      const std::size_t planned_collapses = planned.plan().collapses.size();
      std::size_t done = 0;
      if constexpr (is_mixed<D>)
        done = decimater.decimate(before, kMcPart);
      else
        done = decimater.decimate(before);
      // ModRoundnessT takes a face that vanishes for one that is left, finds it degenerate, and forbids most
      // collapses.
      if (constraint != kRoundness) CHECK(done > 0);
      CHECK(done <= planned_collapses);
      CHECK(n_living(mesh) == before - done);
      check_sound(mesh);
    }
}

template <typename D>
void check_targets() {
  for (int module = 0; module < kModules; ++module) {
    INFO("module " << module);
    Mesh vertices = start(), faces = start();
    D to_vertices(vertices), to_faces(faces);
    add_module(to_vertices, module);
    add_module(to_faces, module);
    REQUIRE(to_vertices.initialize());
    REQUIRE(to_faces.initialize());
    if constexpr (is_mixed<D>) {
      to_vertices.decimate_to(520, kMcPart);
      to_faces.decimate_to_faces(0, 1040, kMcPart);
    } else {
      to_vertices.decimate_to(520);
      to_faces.decimate_to_faces(0, 1040);
    }
    CHECK(n_living(vertices) == 520);
    CHECK(n_living(faces) == 520);
  }
}

}  // namespace

TEST_CASE("DecimaterT runs every module beside every constraint") {
  check_all<om::DecimaterT<Mesh>>();
}
TEST_CASE("McDecimaterT runs every module beside every constraint") {
  check_all<om::McDecimaterT<Mesh>>();
}
TEST_CASE("MixedDecimaterT runs every module beside every constraint") {
  check_all<om::MixedDecimaterT<Mesh>>();
}

TEST_CASE("modules meet targets in every decimater") {
  check_targets<om::DecimaterT<Mesh>>();
  check_targets<om::McDecimaterT<Mesh>>();
  check_targets<om::MixedDecimaterT<Mesh>>();
}

TEST_CASE("without constraints DecimaterT executes all of every plan") {
  for (int module = 0; module < kModules; ++module) {
    Mesh mesh = start();
    om::DecimaterT<Mesh> decimater(mesh);
    PlannedModule& planned = add_module(decimater, module);
    REQUIRE(decimater.initialize());
    const std::size_t collapses = planned.plan().collapses.size();
    CHECK(decimater.decimate() == collapses);
  }
}

TEST_CASE("a module tells what has become of its plan and of every vertex") {
  Mesh mesh = start();
  om::DecimaterT<Mesh> decimater(mesh);
  auto& fass = add<ModFassT<Mesh>>(decimater);
  fass.set_radius(0.12);
  SECTION("all of it") {
    REQUIRE(decimater.initialize());
    decimater.decimate();
    const PlanOutcome outcome = fass.outcome();
    CHECK(outcome.executed == outcome.planned);
    CHECK(outcome.illegal + outcome.apart + outcome.left == 0);
  }
  SECTION("a part, for it was stopped") {
    REQUIRE(decimater.initialize());
    decimater.decimate(20);
    const PlanOutcome outcome = fass.outcome();
    CHECK(outcome.executed == 20);
    CHECK(outcome.left > 0);
    CHECK(outcome.executed + outcome.illegal + outcome.apart + outcome.left == outcome.planned);
  }
  SECTION("a part, for another module forbade it") {
    add<om::ModNormalFlippingT<Mesh>>(decimater).set_max_normal_deviation(5);
    REQUIRE(decimater.initialize());
    decimater.decimate();
    const PlanOutcome outcome = fass.outcome();
    CHECK(outcome.executed < outcome.planned);
    CHECK(outcome.executed + outcome.illegal + outcome.apart + outcome.left == outcome.planned);
  }
  const std::vector<int> map = fass.vertex_map();
  REQUIRE(map.size() == mesh.n_vertices());
  for (std::size_t v = 0; v < map.size(); ++v) {
    CHECK_FALSE(mesh.status(Mesh::VertexHandle(map[v])).deleted());
    if (!mesh.status(Mesh::VertexHandle(int(v))).deleted()) CHECK(map[v] == int(v));
  }
}

TEST_CASE("a tolerance per vertex holds vertices and widens thresholds") {
  Mesh mesh = start();
  OpenMesh::VPropHandleT<float> tolerance;
  mesh.add_property(tolerance);
  om::DecimaterT<Mesh> decimater(mesh);
  auto& ivdd = add<ModVertexDistanceT<Mesh>>(decimater);
  ivdd.set_max_distance(0.1);
  const std::size_t neutral = ivdd.plan().collapses.size();
  REQUIRE(neutral > 0);
  ivdd.set_tolerance(tolerance);
  const auto all = [&](float value) {
    for (const auto v : mesh.vertices()) mesh.property(tolerance, v) = value;
    ivdd.initialize();
    return ivdd.plan().collapses.size();
  };
  CHECK(all(1) == neutral);
  CHECK(all(0) == 0);
  CHECK(all(2) > neutral);
  for (const auto v : mesh.vertices()) mesh.property(tolerance, v) = v.idx() % 2 ? 0.f : 2.f;
  ivdd.initialize();
  for (const Collapse& c : ivdd.plan().collapses) CHECK((c.from % 2 == 0 && c.to % 2 == 0));
  mesh.property(tolerance, Mesh::VertexHandle(3)) = -1;
  CHECK_THROWS_AS(ivdd.initialize(), InvalidParameter);
  ivdd.set_tolerance(OpenMesh::VPropHandleT<float>());
  CHECK(ivdd.plan().collapses.size() == neutral);
}

TEST_CASE("passes are one plan, and more of them go further") {
  Mesh mesh = start();
  om::DecimaterT<Mesh> decimater(mesh);
  auto& scan = add<ModSphereScanT<Mesh>>(decimater);
  scan.set_radius(0.12);
  const std::size_t one = scan.plan().collapses.size();
  scan.set_passes(2);
  const std::size_t two = scan.plan().collapses.size();
  scan.set_passes(ModSphereScanT<Mesh>::kUntilRest);
  const std::size_t rest = scan.plan().collapses.size();
  CHECK(one < two);
  CHECK(two <= rest);
  CHECK_THROWS_AS(scan.set_passes(0), InvalidParameter);
  REQUIRE(decimater.initialize());
  CHECK(decimater.decimate() == rest);
  check_sound(mesh);
  scan.initialize();
  CHECK(scan.plan().collapses.empty());  // it is at rest
}
