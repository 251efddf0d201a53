#include "speed/shapes.hh"

#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

#include "experiment/Machine.hh"
#include "measure/Distance.hh"
#include "recipe/Recipe.hh"
#include "recipe/Spec.hh"
#include "text/format.hh"
#include "whittle/surface/constants.hh"

namespace whittle::speed {
namespace {

using Point = IndexedMesh::Point;

std::vector<Point> circle(std::uint32_t n, double z) {
  std::vector<Point> points;
  for (std::uint32_t i = 0; i < n; ++i)
    points.emplace_back(std::cos(2 * detail::kPi * i / n), std::sin(2 * detail::kPi * i / n), z);
  return points;
}

IndexedMesh fan(std::uint32_t n) {
  IndexedMesh mesh;
  mesh.points = circle(n, 0);
  mesh.points.emplace_back(0, 0, 0.1);
  for (std::uint32_t i = 0; i < n; ++i) mesh.triangles.push_back({n, i, (i + 1) % n});
  return mesh;
}

/// Half a disc in a plane, around a vertex on its boundary.
IndexedMesh open_fan(std::uint32_t n) {
  IndexedMesh mesh;
  for (std::uint32_t i = 0; i <= n; ++i)
    mesh.points.emplace_back(std::cos(detail::kPi * i / n), std::sin(detail::kPi * i / n), 0);
  mesh.points.emplace_back(0, 0, 0);
  for (std::uint32_t i = 0; i < n; ++i) mesh.triangles.push_back({n + 1, i, i + 1});
  return mesh;
}

IndexedMesh bipyramid(std::uint32_t n) {
  IndexedMesh mesh;
  mesh.points = circle(n / 2, 0);
  mesh.points.insert(mesh.points.end(), {{0, 0, 0.5}, {0, 0, -0.5}});
  for (std::uint32_t i = 0, m = n / 2; i < m; ++i) {
    mesh.triangles.push_back({m, i, (i + 1) % m});
    mesh.triangles.push_back({m + 1, (i + 1) % m, i});
  }
  return mesh;
}

IndexedMesh book(std::uint32_t n) {
  IndexedMesh mesh;
  mesh.points = circle(n, 0.5);
  mesh.points.insert(mesh.points.end(), {{0, 0, 0}, {0, 0, 1}});
  for (std::uint32_t i = 0; i < n; ++i) mesh.triangles.push_back({n, n + 1, i});
  return mesh;
}

/// Octahedra on a sphere, each with a corner in its centre.
IndexedMesh bouquet(std::uint32_t n) {
  IndexedMesh mesh;
  mesh.points.emplace_back(0, 0, 0);
  const std::uint32_t pieces = n / 8;
  const double radius = 0.3 / std::sqrt(pieces), golden = detail::kPi * (3 - std::sqrt(5.0));
  for (std::uint32_t i = 0; i < pieces; ++i) {
    const double z = 1 - (2 * i + 1.0) / pieces, r = std::sqrt(1 - z * z);
    const Point out(r * std::cos(golden * i), r * std::sin(golden * i), z), u = out.unitOrthogonal(),
                                                                            v = out.cross(u);
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const Point& side : {u, v, Point(-u), Point(-v)}) mesh.points.emplace_back(out / 2 + radius * side);
    mesh.points.push_back(out);
    for (std::uint32_t k = 0; k < 4; ++k) {
      mesh.triangles.push_back({0, first + (k + 1) % 4, first + k});
      mesh.triangles.push_back({first + 4, first + k, first + (k + 1) % 4});
    }
  }
  return mesh;
}

IndexedMesh lone_faces(std::uint32_t n, double spread) {
  std::mt19937 random(1);
  const auto next = [&] { return static_cast<double>(random()) / 4294967296.0; };
  IndexedMesh mesh;
  for (std::uint32_t i = 0; i < n; ++i) {
    const Point at = spread * Point{next(), next(), next()};
    mesh.points.insert(mesh.points.end(), {at, at + Point(0.02, 0, 0), at + Point(0, 0.02, 0)});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

IndexedMesh plane(std::uint32_t n) {
  IndexedMesh mesh;
  const auto side = static_cast<std::uint32_t>(std::sqrt(n / 2.0)) + 1;
  for (std::uint32_t j = 0; j < side; ++j)
    for (std::uint32_t i = 0; i < side; ++i) mesh.points.emplace_back(i, j, 0);
  for (std::uint32_t j = 0; j + 1 < side; ++j)
    for (std::uint32_t i = 0; i + 1 < side; ++i) {
      const std::uint32_t v = j * side + i;
      mesh.triangles.push_back({v, v + 1, v + side + 1});
      mesh.triangles.push_back({v, v + side + 1, v + side});
    }
  return mesh;
}

/// What is timed, and how the table calls it.
struct Work {
  std::string name;
  recipe::Recipe recipe;  ///< without modules: the distance of the mesh from itself
};

std::vector<Work> works() {
  std::vector<Work> all;
  for (const char* spec :
       {"vt", "vt:placement=quadric,order=error", "fad:angle=180", "fad:angle=180,pairs=all",
        "ivdd:distance=1e", "ss:radius=1e", "ss:radius=1e,placement=quadric,order=error", "vtd:distance=1e",
        "fass:radius=1e"}) {
    recipe::Recipe recipe;
    recipe.modules = {recipe::parse_spec(spec)};
    all.push_back({spec, recipe});
  }
  for (const char* spec : {"mq", "quadric"}) {
    recipe::Recipe recipe;
    recipe.modules = {recipe::parse_spec(spec)};
    recipe.target.ratio = 0.1;
    all.push_back({std::string(spec) + " to 10 %", recipe});
    if (all.back().name.front() != 'm') continue;
    recipe.driver = recipe::Driver::sweep;
    all.push_back({std::string(spec) + " to 10 %, sweep", recipe});
  }
  recipe::Recipe bounded;
  bounded.modules = {recipe::parse_spec("mq")};
  bounded.max_distance = recipe::parse_length("1%");
  all.push_back({"mq within 1 %", bounded});
  recipe::Recipe flips;
  flips.modules = {recipe::parse_spec("ivdd:distance=0")};
  flips.delaunay = 20;
  all.push_back({"Delaunay flips", flips});
  all.push_back({"distance from itself", {}});
  return all;
}

double seconds_once(const IndexedMesh& mesh, const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  if (work.recipe.modules.empty())
    measure::distance(mesh, mesh);
  else
    recipe::run(mesh, work.recipe);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The least of five, of which short ones vary much, or the only one where it is long.
double seconds(const IndexedMesh& mesh, const Work& work) {
  constexpr double kLong = 1;
  double least = seconds_once(mesh, work);
  for (int i = 1; i < 5 && least < kLong; ++i) least = std::min(least, seconds_once(mesh, work));
  return least;
}

/// What a run gives back stays with the process. Otherwise the system would hand out the pages of the larger arrays
/// anew each time, which takes longer than most of the work.
void keep_memory() {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
}

/// Where and when the times were taken.
std::string heading() {
  const auto machine = bench::machine();
  return "# Growth with valence\n\n" + machine.date_utc + ": " + machine.cpu_model + "; " + machine.compiler +
         ", `" + machine.flags + "`; commit " + machine.commit +
         (machine.commit_dirty ? " with changes" : "") + "\n\n";
}

}  // namespace

std::vector<Shape> shapes(std::size_t n_faces) {
  const auto n = static_cast<std::uint32_t>(n_faces);
  return {{"fan", fan(n)},
          {"open fan", open_fan(n)},
          {"bipyramid", bipyramid(n)},
          {"book", book(n)},
          {"bouquet", bouquet(n)},
          {"coincident faces", lone_faces(n, 0)},
          {"soup", lone_faces(n, 1)},
          {"plane", plane(n)}};
}

std::string shapes_page(const std::optional<std::regex>& only, terminal::Progress& progress) {
  constexpr std::size_t kSmall = 20000, kLarge = 80000;
  constexpr double kTooLong = 30;  // seconds on the small one, after which the large one is left out
  const std::vector<Shape> small = shapes(kSmall), large = shapes(kLarge);
  keep_memory();
  std::string page =
      heading() + "| shape | | 20,000 faces, ms | 80,000 faces, ms | ratio |\n|---|---|---:|---:|---:|\n";
  for (std::size_t i = 0; i < small.size(); ++i)
    for (const Work& work : works()) {
      const std::string line = small[i].name + " | " + work.name;
      if (only && !std::regex_search(line, *only)) continue;
      progress.say(line);
      const double first = seconds(small[i].mesh, work);
      page += "| " + line + " | " + text::format("%.1f", 1000 * first) + " | ";
      if (first > kTooLong) {
        page += "left out | |\n";
        continue;
      }
      const double second = seconds(large[i].mesh, work);
      page += text::format("%.1f", 1000 * second) + " | " + text::format("%.1f", second / first) + " |\n";
    }
  return page;
}

}  // namespace whittle::speed
