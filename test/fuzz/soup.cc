/// \file
/// A fuzz target: planners and executors on any triangle soup.
///
/// The first bytes choose module, target, driver and retriangulation, the others are points and triangles.
/// Every guarantee must hold, and with every driver a closed manifold mesh becomes the same.
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

constexpr recipe::Driver kDrivers[] = {recipe::Driver::bulk, recipe::Driver::sweep, recipe::Driver::lazy,
                                       recipe::Driver::decimater, recipe::Driver::mc};

void require(const std::string& broken) {
  if (broken.empty()) return;
  std::fprintf(stderr, "does not hold: %s\n", broken.c_str());
  std::abort();
}

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
  const recipe::Result result = recipe::run(mesh, recipe);
  require(corpus::broken(before, taken, recipe, result));
  if (!has_plan && (driver == recipe::Driver::bulk || driver == recipe::Driver::sweep)) return 0;
  recipe.driver = driver;
  const recipe::Result driven = recipe::run(mesh, recipe);
  require(corpus::broken(before, taken, recipe, driven));
  // At boundaries OpenMesh refuses a little more, as the tip of an ear; and mc draws.
  const bool does_all = has_plan && driver != recipe::Driver::mc && before.facts.closed() &&
                        before.facts.nonmanifold_vertices == 0 && driven.refused_faces == 0;
  if (does_all && (driven.vertex_map != result.vertex_map ||
                   driven.mesh.triangles.size() != result.mesh.triangles.size()))
    require(recipe::to_string(driver) + " does not do what bulk does");
  return 0;
}
