/// \file
/// A fuzz target: modules that move seams, on sound meshes with any charts.
///
/// The first bytes choose module, target, driver, mesh and kind of seams, the others charts, heights and slits. The
/// guarantees must hold; what is closed stays closed; no value leaves its chart; on closed meshes all drivers agree.
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <map>
#include <string>

#include "corpus/Guarantees.hh"
#include "meshes.hh"
#include "recipe/Recipe.hh"

namespace {

using namespace whittle;

/// The input again and again, so that every face has a chart; zeros where there is none.
class Wheel {
 public:
  Wheel(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  unsigned next() { return size_ == 0 ? 0 : data_[at_++ % size_]; }

 private:
  const std::uint8_t* data_;
  std::size_t size_, at_ = 0;
};

const char* const kMovers[] = {"mq",
                               "mq:charts=keep",
                               "mq:feature=20",
                               "mq:max-distance=0.5",
                               "mq:texture=0",
                               "quadric",
                               "quadric:charts=keep",
                               "ivdd:distance=2e,seams=merge",
                               "fass:radius=1e,angle=40,seams=merge"};

constexpr recipe::Driver kSeamDrivers[] = {recipe::Driver::bulk, recipe::Driver::sweep, recipe::Driver::lazy,
                                           recipe::Driver::decimater};

IndexedMesh sound_mesh(unsigned kind, Wheel& bytes) {
  IndexedMesh mesh = kind % 3 == 0   ? meshes::octahedron()
                     : kind % 3 == 1 ? meshes::torus(9, 6)
                                     : meshes::flat_grid(8);
  const double amount = kind % 3 == 2 ? 0.3 : 0.02;
  for (auto& p : mesh.points) p.z() += amount * bytes.next() / 255.0;
  return mesh;
}

struct Charted {
  attributes::Attributes texture;
  std::vector<std::uint32_t> chart;
  bool has_slits = false;
};

/// A chart for each face, a byte for several in a row; with slits, corners that differ from their neighbours at
/// random.
Charted charted(const IndexedMesh& mesh, unsigned kind, Wheel& bytes) {
  Charted out;
  out.has_slits = kind % 4 == 3;
  const unsigned in_a_row = 1 + kind / 4 % 8, n_charts = 2 + kind / 32;
  attributes::Attribute texture{attributes::Kind::texture, "", 2, false, false, {}, {}};
  unsigned chart = 0;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    if (f % in_a_row == 0) chart = bytes.next() % n_charts;
    out.chart.push_back(chart);
    auto& corners = texture.corners.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = mesh.points[mesh.triangles[f][k]];
      const double slit = out.has_slits && bytes.next() % 16 == 0 ? 0.25 : 0;
      corners[k] = static_cast<std::uint32_t>(texture.n_values());
      texture.values.push_back(static_cast<float>(p.x() + 100.0 * chart + slit));
      texture.values.push_back(static_cast<float>(p.y()));
    }
  }
  out.texture = {texture};
  return out;
}

void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what.c_str());
  std::abort();
}

using Box = Eigen::AlignedBox2d;

Eigen::Vector2d place(const attributes::Attribute& texture, std::uint32_t value) {
  return {static_cast<double>(texture.value(value)[0]), static_cast<double>(texture.value(value)[1])};
}

/// Every value is in the range of its face's chart.
void require_in_charts(const Charted& given, const recipe::Result& result) {
  std::map<std::uint32_t, Box> ranges;
  const attributes::Attribute& before = given.texture[0];
  for (std::size_t f = 0; f < given.chart.size(); ++f)
    for (const std::uint32_t value : before.corners[f]) ranges[given.chart[f]].extend(place(before, value));
  const attributes::Attribute& after = result.attributes.at(0);
  require(after.corners.size() == result.mesh.triangles.size(), "a value for each corner");
  for (std::size_t f = 0; f < after.corners.size(); ++f)
    for (const std::uint32_t value : after.corners[f]) {
      require(value < after.n_values(), "a value for each corner");
      const Box& range = ranges[given.chart[result.face_origin[f]]];
      require(range.exteriorDistance(place(after, value)) < 1e-3, "a value in its chart");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 5) return 0;
  Wheel bytes(data + 5, size - 5);
  recipe::Recipe recipe;
  recipe.modules = {recipe::parse_spec(kMovers[data[0] % std::size(kMovers)])};
  recipe.target.faces = 1 + data[1] / 2;
  const IndexedMesh mesh = sound_mesh(data[3], bytes);
  const Charted given = charted(mesh, data[4], bytes);
  recipe::Givens givens;
  givens.attributes = &given.texture;

  const corpus::Counted before(mesh), taken(corpus::as_openmesh_takes_it(mesh));
  const recipe::Result result = recipe::run(mesh, recipe, {}, givens);
  const std::string broken = corpus::broken(before, taken, recipe, result);
  require(broken.empty(), broken);
  require_in_charts(given, result);
  const bool keeps = recipe.modules[0].word("charts") == "keep";
  require(!keeps || result.charts_gone == 0, "every chart has a face");

  if (recipe.modules[0].name == "quadric") return 0;
  recipe.driver = kSeamDrivers[data[2] % std::size(kSeamDrivers)];
  const recipe::Result driven = recipe::run(mesh, recipe, {}, givens);
  require_in_charts(given, driven);
  if (before.facts.closed())
    require(driven.vertex_map == result.vertex_map,
            recipe::to_string(recipe.driver) + " does what bulk does");
  return 0;
}
