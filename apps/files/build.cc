#include "files/build.hh"

#include <algorithm>
#include <cmath>
#include <limits>

#include "files/Fault.hh"

namespace whittle::files {

void add_point(MeshFile& file, double x, double y, double z) {
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) throw Fault("a coordinate is not finite");
  if (file.mesh.points.size() == std::numeric_limits<std::uint32_t>::max())
    throw Fault("more vertices than 32-bit indices can name");
  file.mesh.points.emplace_back(x, y, z);
}

void add_face(MeshFile& file, const std::vector<std::uint32_t>& corners) {
  if (corners.size() < 3) throw Fault("a face has fewer than three vertices");
  if (corners.size() > 3) ++file.report.polygons;
  const std::uint32_t a = corners[0];
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const std::uint32_t b = corners[i - 1];
    const std::uint32_t c = corners[i];
    if (a == b || b == c || c == a)
      ++file.report.dropped_degenerate;
    else
      file.mesh.triangles.push_back({a, b, c});
  }
}

void ignore(MeshFile& file, const std::string& attribute) {
  std::vector<std::string>& ignored = file.report.ignored;
  if (std::find(ignored.begin(), ignored.end(), attribute) == ignored.end()) ignored.push_back(attribute);
}

std::uint32_t checked_index(std::int64_t index, std::size_t vertices) {
  if (index < 0 || static_cast<std::uint64_t>(index) >= vertices) throw_index_out_of_range(index, vertices);
  return static_cast<std::uint32_t>(index);
}

void throw_index_out_of_range(std::int64_t index, std::size_t vertices) {
  throw Fault("vertex index " + std::to_string(index) + " is out of range: there are " +
              std::to_string(vertices) + " vertices");
}

void check_declared(std::uint64_t count, const std::string& things, std::size_t least_bytes,
                    std::size_t remaining) {
  // One more, because the last line of a text file may lack its line end.
  if (count > remaining / least_bytes + 1)
    throw Fault("the file is cut off: " + std::to_string(count) + " " + things + " do not fit in the " +
                std::to_string(remaining) + " bytes left");
}

}  // namespace whittle::files
