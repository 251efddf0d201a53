/// \file
/// A program of the projects beside it that links whittle::compiled, where mq is compiled already: arrays of floats.
#include <iostream>
#include <whittle/bulk.hh>
#include <whittle/planners/MemorylessQuadric.hh>

#ifndef WHITTLE_COMPILED
#error "the target whittle::compiled defines WHITTLE_COMPILED"
#endif

int main() {
  whittle::IndexedMeshT<float> mesh;
  constexpr unsigned n = 12;
  for (unsigned j = 0; j < n; ++j)
    for (unsigned i = 0; i < n; ++i) mesh.points.emplace_back(float(i), float(j), 0.f);
  for (unsigned j = 0; j + 1 < n; ++j)
    for (unsigned i = 0; i + 1 < n; ++i) {
      const unsigned v = j * n + i;
      mesh.triangles.push_back({v, v + 1, v + n + 1});
      mesh.triangles.push_back({v, v + n + 1, v + n});
    }
  whittle::MemorylessQuadric mq;
  mq.target_faces = 2;
  const auto result = whittle::bulk(mq, mesh);
  std::cout << result.mesh.triangles.size() << " faces\n";
  return result.mesh.triangles.size() == 2 ? 0 : 1;
}
