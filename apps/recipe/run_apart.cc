#include "recipe/run_apart.hh"

#include <algorithm>
#include <map>
#include <utility>

#include "files/subset.hh"

namespace whittle::recipe {
namespace {

using Triangle = IndexedMesh::Triangle;

/// Those of the elements of a list that are named; none where the list is empty.
template <typename T>
std::vector<T> taken(const std::vector<T>& all, const std::vector<std::uint32_t>& which) {
  std::vector<T> out;
  for (std::size_t i = 0; i < which.size() && !all.empty(); ++i) out.push_back(all[which[i]]);
  return out;
}

/// Puts the results of bodies together.
class Collector {
 public:
  explicit Collector(std::size_t vertices) { all_.vertex_map.resize(vertices, Result::kNoVertex); }

  /// \param vertices, faces  of the whole mesh, in the body's order
  void add(Result&& one, const std::vector<std::uint32_t>& vertices,
           const std::vector<std::uint32_t>& faces) {
    const auto first = static_cast<std::uint32_t>(all_.mesh.points.size());
    for (std::size_t v = 0; v < vertices.size(); ++v)
      if (one.vertex_map[v] != Result::kNoVertex) all_.vertex_map[vertices[v]] = first + one.vertex_map[v];
    for (const std::uint32_t face : one.face_origin) all_.face_origin.push_back(faces[face]);
    add_attributes(one);
    all_.mesh.points.insert(all_.mesh.points.end(), one.mesh.points.begin(), one.mesh.points.end());
    for (const auto& [a, b, c] : one.mesh.triangles)
      all_.mesh.triangles.push_back({first + a, first + b, first + c});
    all_.parts.insert(all_.parts.end(), one.parts.begin(), one.parts.end());
    std::move(one.stages.begin(), one.stages.end(), std::back_inserter(all_.stages));
    add_figures(one);
  }

  Result take() {
    for (attributes::Attribute& attribute : all_.attributes)
      if (per_vertex_[static_cast<std::size_t>(&attribute - all_.attributes.data())])
        attribute.corners.clear();
    return std::move(all_);
  }

 private:
  /// At corners, until it is known that all bodies have them at vertices.
  void add_attributes(const Result& one) {
    const bool is_first = all_.attributes.empty();
    if (is_first) per_vertex_.assign(one.attributes.size(), true);
    for (std::size_t i = 0; i < one.attributes.size(); ++i) {
      const attributes::Attribute& from = one.attributes[i];
      if (is_first) {
        all_.attributes.push_back(from);
        all_.attributes.back().values.clear();
        all_.attributes.back().corners.clear();
      }
      attributes::Attribute& to = all_.attributes[i];
      const auto first = static_cast<std::uint32_t>(to.n_values());
      for (std::size_t f = 0; f < one.mesh.triangles.size(); ++f) {
        Triangle corners{};
        for (std::size_t k = 0; k < 3; ++k) corners[k] = first + from.at(one.mesh, f, k);
        to.corners.push_back(corners);
      }
      to.values.insert(to.values.end(), from.values.begin(), from.values.end());
      per_vertex_[i] = per_vertex_[i] && from.per_vertex();
    }
  }

  void add_figures(const Result& one) {
    all_.refused_faces += one.refused_faces;
    if (one.distance) all_.distance = std::max(all_.distance.value_or(0), *one.distance);
    all_.bound_held = all_.bound_held && one.bound_held;
    all_.held_by_bound += one.held_by_bound;
    all_.held += one.held;
    all_.held_on_seams += one.held_on_seams;
    all_.charts += one.charts;
    all_.charts_gone += one.charts_gone;
    all_.pieces_gone += one.pieces_gone;
    all_.faces_of_pieces_gone += one.faces_of_pieces_gone;
    all_.attainable.is_higher = all_.attainable.is_higher || one.attainable.is_higher;
    all_.attainable.target.faces += one.attainable.target.faces;
    all_.attainable.target.vertices += one.attainable.target.vertices;
    all_.attainable.minimum += one.attainable.minimum;
    all_.attainable.pieces += one.attainable.pieces;
    all_.attainable.small += one.attainable.small;
    all_.attainable.charts += one.attainable.charts;
    all_.attainable.held += one.attainable.held;
    all_.stopped_by_bound = all_.stopped_by_bound || one.stopped_by_bound;
    all_.retriangulation_dropped = all_.retriangulation_dropped || one.retriangulation_dropped;
    all_.refit_dropped = all_.refit_dropped || one.refit_dropped;
    if (one.refit) {
      RefitReport sum = all_.refit.value_or(RefitReport());
      sum.moved += one.refit->moved;
      sum.refused += one.refit->refused;
      all_.refit = sum;
    }
    all_.refit_seconds += one.refit_seconds;
    all_.delaunay.flipped += one.delaunay.flipped;
    all_.delaunay.refused_by_guard += one.delaunay.refused_by_guard;
    all_.delaunay.refused_by_topology += one.delaunay.refused_by_topology;
    all_.delaunay.converged = all_.delaunay.converged && one.delaunay.converged;
    all_.flipped_faces += one.flipped_faces;
    all_.target_reached = all_.target_reached && one.target_reached;
  }

  Result all_;
  std::vector<bool> per_vertex_;
};

}  // namespace

Result run_apart(const IndexedMesh& mesh, const std::vector<std::uint32_t>& body, const Recipe& recipe,
                 const Monitor& monitor, const Givens& givens) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> faces;
  for (std::uint32_t face = 0; face < body.size(); ++face) faces[body[face]].push_back(face);
  if (faces.size() <= 1) return run(mesh, recipe, monitor, givens);
  const attributes::Attributes none;
  Collector all(mesh.points.size());
  for (const auto& [number, list] : faces) {
    const files::FacesAlone alone =
        files::faces_alone(mesh, givens.attributes ? *givens.attributes : none, list);
    const std::vector<std::uint32_t> parts =
        givens.parts ? taken(*givens.parts, list) : std::vector<std::uint32_t>();
    Givens own = givens;
    own.flags = taken(givens.flags, alone.vertices);
    own.tolerance = taken(givens.tolerance, alone.vertices);
    own.areas = taken(givens.areas, list);
    own.attributes = &alone.attributes;
    own.parts = &parts;
    all.add(run(alone.mesh, recipe, monitor, own), alone.vertices, list);
  }
  return all.take();
}

}  // namespace whittle::recipe
