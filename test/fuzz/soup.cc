/// \file
/// A fuzz target: planners and executors on any triangle soup.
///
/// The first bytes choose module, target, driver, retriangulation and texture, the others are points and triangles.
/// Every guarantee must hold, and with every driver a closed manifold mesh becomes the same.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string>

#include "corpus/Guarantees.hh"
#include "recipe/Recipe.hh"

namespace {

using namespace whittle;

/// Takes the input apart, byte by byte; zeros when it has come to its end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  unsigned next() {
    if (size_ == 0) return 0;
    --size_;
    return *data_++;
  }
  bool empty() const { return size_ == 0; }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

const char* const kModules[] = {"vt",
                                "vt:placement=quadric,order=error,passes=2",
                                "fad:angle=60",
                                "fad:angle=170,lock=strict,pairs=all,boundary=merge,passes=3",
                                "ivdd:distance=3",
                                "ivdd:distance=5,boundary=merge,passes=3,guard=-1",
                                "ss:radius=4",
                                "ss:radius=6,placement=quadric,order=error,passes=2",
                                "vtd:distance=4,fold=literal",
                                "fass:radius=4,angle=90",
                                "mq",
                                "quadric"};
const char* const kBounded = "mq:max-distance=1";

/// A few points on a coarse grid, so that many coincide or lie in a plane, and any triangles on them.
IndexedMesh soup(Bytes& bytes) {
  IndexedMesh mesh;
  const unsigned n = 3 + bytes.next() % 30;
  for (unsigned i = 0; i < n; ++i) {
    const unsigned x = bytes.next(), y = bytes.next();
    mesh.points.emplace_back(x % 8, x / 32, y % 8);
  }
  while (!bytes.empty() && mesh.triangles.size() < 200)
    mesh.triangles.push_back({bytes.next() % n, bytes.next() % n, bytes.next() % n});
  return mesh;
}

enum class SeamsOfSoup { none, around_each_face, around_some_faces, anywhere };

/// Texture coordinates at the corners, with seams.
attributes::Attributes textured(const IndexedMesh& mesh, SeamsOfSoup seams) {
  if (seams == SeamsOfSoup::none || mesh.triangles.empty()) return {};
  attributes::Attribute out{attributes::Kind::texture, "", 2, false, false, {}, {}};
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    auto& corners = out.corners.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = mesh.points[mesh.triangles[f][k]];
      const std::size_t chart = seams == SeamsOfSoup::around_each_face    ? f
                                : seams == SeamsOfSoup::around_some_faces ? f / 7
                                                                          : (5 * f + 3 * k) % 7 / 6;
      corners[k] = static_cast<std::uint32_t>(out.n_values());
      out.values.push_back(static_cast<float>(p.x() + 10 * static_cast<double>(chart)));
      out.values.push_back(static_cast<float>(p.y()));
    }
  }
  return {out};
}

void require(const std::string& broken) {
  if (broken.empty()) return;
  std::fprintf(stderr, "does not hold: %s\n", broken.c_str());
  std::abort();
}

/// Every corner of the result has a value, and a finite one.
void require_values(const recipe::Result& result) {
  for (const auto& attribute : result.attributes) {
    if (attribute.corners.size() != result.mesh.triangles.size()) require("a value for each corner");
    for (const auto& corners : attribute.corners)
      for (const std::uint32_t value : corners)
        if (value >= attribute.n_values() || !std::isfinite(attribute.value(value)[0]))
          require("a finite value at each corner");
  }
}

constexpr recipe::Driver kDrivers[] = {recipe::Driver::bulk, recipe::Driver::sweep, recipe::Driver::lazy,
                                       recipe::Driver::decimater, recipe::Driver::mc};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  recipe::Recipe recipe;
  const unsigned module = bytes.next();
  recipe.modules = {recipe::parse_spec(
      module < 20 * std::size(kModules) ? kModules[module % std::size(kModules)] : kBounded)};
  const bool has_plan = recipe.modules[0].name != "quadric";
  const unsigned goal = bytes.next();
  if (!has_plan || recipe.modules[0].name == "mq" || goal % 2) recipe.target.faces = 1 + goal / 2;
  const unsigned choice = bytes.next();
  const auto driver = kDrivers[choice / 4 % std::size(kDrivers)];
  if (choice % 4 == 0) recipe.delaunay = 90;
  const IndexedMesh mesh = soup(bytes);

  const corpus::Counted before(mesh), taken(corpus::as_openmesh_takes_it(mesh));
  const attributes::Attributes texture = textured(mesh, static_cast<SeamsOfSoup>(choice / 64));
  recipe::Givens givens;
  givens.attributes = &texture;
  const recipe::Result result = recipe::run(mesh, recipe, {}, givens);
  require(corpus::broken(before, taken, recipe, result));
  require_values(result);
  if (!has_plan && (driver == recipe::Driver::bulk || driver == recipe::Driver::sweep)) return 0;
  recipe.driver = driver;
  const recipe::Result driven = recipe::run(mesh, recipe, {}, givens);
  require(corpus::broken(before, taken, recipe, driven));
  require_values(driven);
  // At boundaries OpenMesh refuses a little more, as the tip of an ear; and mc draws.
  const bool does_all = has_plan && driver != recipe::Driver::mc && before.facts.closed() &&
                        before.facts.nonmanifold_vertices == 0 && driven.refused_faces == 0;
  if (does_all && (driven.vertex_map != result.vertex_map ||
                   driven.mesh.triangles.size() != result.mesh.triangles.size()))
    require(recipe::to_string(driver) + " does not do what bulk does");
  return 0;
}
