/// \file
/// A fuzz target: planners and executors on any triangle soup.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "measure/MeshFacts.hh"
#include "recipe/Recipe.hh"
#include "whittle/errors.hh"

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

[[noreturn]] void fail() {
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  recipe::Recipe recipe;
  const unsigned which = bytes.next();
  recipe.modules = {recipe::parse_spec(kModules[which % std::size(kModules)])};
  const unsigned goal = bytes.next();
  const bool needs_target = recipe.modules[0].name == "mq" || recipe.modules[0].name == "quadric";
  if (needs_target || goal % 2) recipe.target.faces = 1 + goal / 2;
  if (bytes.next() % 4 == 0) recipe.delaunay = 90;
  const IndexedMesh mesh = soup(bytes);

  const recipe::Result result = recipe::run(mesh, recipe);
  for (const auto& t : result.mesh.triangles)
    for (const std::uint32_t v : t)
      if (v >= result.mesh.points.size()) fail();
  for (const auto& p : result.mesh.points)
    if (!p.allFinite()) fail();
  if (result.vertex_map.size() != mesh.points.size()) fail();
  for (const std::uint32_t v : result.vertex_map)
    if (v >= result.mesh.points.size()) fail();
  const auto before = measure::facts(mesh), after = measure::facts(result.mesh);
  if (after.faces > before.faces) fail();
  if (after.nonmanifold_edges > before.nonmanifold_edges) fail();
  return 0;
}
