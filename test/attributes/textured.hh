/// \file
/// Meshes with texture coordinates, and recipes for them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>

#include "attributes/Attribute.hh"
#include "meshes.hh"
#include "recipe/Recipe.hh"

namespace fixture {

using whittle::IndexedMesh;
using whittle::attributes::Attribute;
using whittle::attributes::Attributes;
using whittle::attributes::Kind;
namespace recipe = whittle::recipe;

inline recipe::Recipe mq_down_to(std::size_t faces, const std::string& spec = "mq") {
  recipe::Recipe recipe;
  recipe.modules = {recipe::parse_spec(spec)};
  recipe.target.faces = faces;
  return recipe;
}

/// Texture coordinates from `at(face, point)`, a value for each corner.
template <typename At>
Attribute textured(const IndexedMesh& mesh, At at) {
  Attribute out{Kind::texture, "", 2, false, false, {}, {}};
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    auto& corners = out.corners.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = static_cast<std::uint32_t>(out.n_values());
      const Eigen::Vector2d uv = at(f, mesh.points[mesh.triangles[f][k]]);
      out.values.push_back(static_cast<float>(uv[0]));
      out.values.push_back(static_cast<float>(uv[1]));
    }
  }
  return out;
}

inline recipe::Result run_with(const IndexedMesh& mesh, const recipe::Recipe& recipe,
                               const Attributes& given) {
  recipe::Givens givens;
  givens.attributes = &given;
  return recipe::run(mesh, recipe, {}, givens);
}

inline Eigen::Vector2d uv_at(const Attribute& texture, std::uint32_t value) {
  return {texture.value(value)[0], texture.value(value)[1]};
}

}  // namespace fixture
