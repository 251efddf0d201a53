/// \file
/// Figures as JSON. Every figure's name ends with its unit; plain names are counts.
#pragma once

#include <nlohmann/json.hpp>

#include "attributes/TextureError.hh"
#include "files/MeshFile.hh"
#include "measure/Distance.hh"
#include "measure/MeshFacts.hh"
#include "measure/certify.hh"
#include "recipe/Recipe.hh"
#include "whittle/surface/intersections.hh"

namespace whittle::figures {

using Json = nlohmann::ordered_json;

Json to_json(const measure::MeshFacts& facts);
Json to_json(const measure::Distance& distance);
Json to_json(const measure::CertifiedDistance& distance, double diagonal);
/// \param list  the pairs, too
Json to_json(const Intersections& intersections, bool list);
Json to_json(const attributes::TextureError& error, double texels);
Json to_json(const recipe::StageResult& stage);
Json to_json(const files::ReadReport& report);

}  // namespace whittle::figures
