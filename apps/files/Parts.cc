#include "files/Parts.hh"

#include <algorithm>

namespace whittle::files {

std::vector<std::uint32_t> Parts::areas(bool groups) const {
  std::vector<std::uint32_t> areas;
  areas.reserve(of_face.size());
  for (const std::uint32_t part : of_face) areas.push_back(groups ? part : list[part].material);
  const bool is_one =
      std::all_of(areas.begin(), areas.end(), [&](std::uint32_t area) { return area == areas.front(); });
  return is_one ? std::vector<std::uint32_t>() : areas;
}

void Parts::drop_materials() {
  for (Part& part : list) part.material = Part::none;
  materials.clear();
  images.clear();
  in_libraries = false;
  libraries.clear();
}

}  // namespace whittle::files
