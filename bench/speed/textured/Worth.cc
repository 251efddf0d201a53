#include "speed/textured/Worth.hh"

#include <algorithm>
#include <cmath>

#include "measure/Distance.hh"
#include "measure/MeshFacts.hh"

namespace whittle::speed {
namespace {

using attributes::Attribute;
using attributes::Kind;

const Attribute* first_of(const attributes::Attributes& attributes, Kind kind) {
  const auto found =
      std::find_if(attributes.begin(), attributes.end(), [&](const auto& a) { return a.kind == kind; });
  return found == attributes.end() ? nullptr : &*found;
}

}  // namespace

Worth topology(const IndexedMesh& mesh) {
  const measure::MeshFacts facts = measure::facts(mesh);
  Worth worth;
  worth.faces = facts.faces;
  worth.components = facts.components;
  worth.boundary_loops = facts.boundary_loops;
  worth.euler_characteristic = facts.euler_characteristic;
  worth.nonmanifold_edges = facts.nonmanifold_edges;
  return worth;
}

Worth worth(const TexturedModel& original, const IndexedMesh& mesh, const attributes::Attributes& attributes,
            std::size_t samples) {
  Worth worth = topology(mesh);
  measure::DistanceOptions options;
  options.samples = samples;
  const measure::Distance distance = measure::distance(original.mesh, mesh, options);
  worth.rms = 1e4 * distance.two_sided.rms / distance.diagonal;
  const Attribute *texture = first_of(original.attributes, Kind::texture),
                  *texture_after = first_of(attributes, Kind::texture),
                  *colours = first_of(original.attributes, Kind::colour),
                  *colours_after = first_of(attributes, Kind::colour);
  if (texture && texture_after) {
    attributes::TextureErrorOptions on_texture;
    on_texture.samples = samples;
    worth.texture = attributes::texture_error(original.mesh, *texture, mesh, *texture_after, on_texture);
  }
  if (colours && colours_after && colours->components == colours_after->components) {
    worth.colours = attributes::value_error(original.mesh, *colours, mesh, *colours_after, samples);
    const double scale = 255 / std::sqrt(static_cast<double>(colours->components));
    worth.colours->rms *= scale;
    worth.colours->max *= scale;
  }
  return worth;
}

}  // namespace whittle::speed
