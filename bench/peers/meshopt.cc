#include <meshoptimizer.h>

#include <cfloat>
#include <limits>
#include <vector>

#include "peers/peers.hh"

namespace whittle::peers {
namespace {

using Indices = std::vector<unsigned>;
constexpr float kAnyError = FLT_MAX;  // only the target bounds it

Indices simplify(const Arrays& mesh, std::size_t faces) {
  Indices out(3 * mesh.triangles.size());
  out.resize(meshopt_simplify(out.data(), mesh.triangles.front().data(), out.size(),
                              mesh.points.front().data(), mesh.points.size(), sizeof(Arrays::Point),
                              3 * faces, kAnyError, 0, nullptr));
  return out;
}

Indices simplify_sloppy(const Arrays& mesh, std::size_t faces) {
  Indices out(3 * mesh.triangles.size());
  out.resize(meshopt_simplifySloppy(out.data(), mesh.triangles.front().data(), out.size(),
                                    mesh.points.front().data(), mesh.points.size(), sizeof(Arrays::Point),
                                    3 * faces, kAnyError, nullptr));
  return out;
}

/// The triangles of `indices`, with the points of `mesh` that they use, in their old order.
Arrays compacted(const Arrays& mesh, const Indices& indices) {
  constexpr auto kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place(mesh.points.size(), kUnused);
  for (const unsigned index : indices) place[index] = 0;
  Arrays out;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] == kUnused) continue;
    place[i] = static_cast<std::uint32_t>(out.points.size());
    out.points.push_back(mesh.points[i]);
  }
  out.triangles.reserve(indices.size() / 3);
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
    out.triangles.push_back({place[indices[i]], place[indices[i + 1]], place[indices[i + 2]]});
  return out;
}

/// meshoptimizer gives a list of indices of the old points.
template <Indices (*kSimplify)(const Arrays&, std::size_t)>
class MeshoptRun : public Run {
 public:
  void load(const Arrays& mesh) override { mesh_ = &mesh; }
  void simplify(std::size_t request) override { indices_ = kSimplify(*mesh_, request); }
  Arrays result() override { return compacted(*mesh_, indices_); }

 private:
  const Arrays* mesh_ = nullptr;
  Indices indices_;
};

template <Indices (*kSimplify)(const Arrays&, std::size_t)>
Simplifier simplifier(const char* name) {
  Simplifier s;
  s.name = name;
  s.start = []() -> std::unique_ptr<Run> { return std::make_unique<MeshoptRun<kSimplify>>(); };
  s.in_place = true;
  return s;
}

}  // namespace

Simplifier meshopt() {
  return simplifier<simplify>("meshopt_simplify");
}

Simplifier meshopt_sloppy() {
  Simplifier s = simplifier<simplify_sloppy>("meshopt_simplifySloppy");
  s.most = [](std::size_t faces) { return faces; };
  return s;
}

}  // namespace whittle::peers
