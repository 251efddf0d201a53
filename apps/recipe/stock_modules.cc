#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Tools/Decimater/ModAspectRatioT.hh>
#include <OpenMesh/Tools/Decimater/ModEdgeLengthT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModIndependentSetsT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalDeviationT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModRoundnessT.hh>

#include "recipe/StockDecimater.hh"
#include "recipe/keys.hh"
#include "whittle/ModGuardedQuadricT.hh"
#include "whittle/plan/FlipGuard.hh"

namespace whittle::recipe {
namespace {

namespace om = OpenMesh::Decimater;
using Mesh = StockDecimater::Mesh;

void add_quadric(StockDecimater& to, const Spec& spec, const Scale&) {
  auto& module = to.add<ModGuardedQuadricT<Mesh>>();
  if (const auto error = spec.number("max-err")) module.set_max_err(*error, false);
  module.set_boundary_weight(number_of(spec, "boundary-weight"));
  module.set_flip_guard(number_of(spec, "guard"));
  module.set_keep_charts(spec.word("charts") == "keep");
  module.set_weight(to.weights());
}

Module quadric() {
  Module module;
  module.name = "quadric";
  module.role = Role::priority;
  module.meaning = "error quadrics, least error first; the boundary and the faces' sides are kept";
  Key max_err =
      number_key("max-err", 0, HUGE_VAL, "largest quadric error, square units", {1e-12, 1, 1e-6, true});
  max_err.fallback = "required without a target";
  max_err.measure = Measure::square_units;
  Key boundary = number_key("boundary-weight", 0, HUGE_VAL, "weight of the boundary's edges", {0, 100, 10});
  boundary.fallback += ", 0 leaves it free";
  module.keys = {main_key(std::move(max_err)), std::move(boundary), charts_key(),
                 guard_key(FlipGuard().min_cos)};
  module.moves_seams = true;
  module.threshold = "max-err";
  module.cheapest_first = true;
  module.add = add_quadric;
  return module;
}

Module constraint(std::string name, std::string meaning, std::vector<Key> keys,
                  void (*add)(StockDecimater&, const Spec&, const Scale&)) {
  Module module;
  module.name = std::move(name);
  module.role = Role::constraint;
  module.meaning = std::move(meaning);
  module.keys = std::move(keys);
  module.add = add;
  return module;
}

void add_normal_flipping(StockDecimater& to, const Spec& spec, const Scale&) {
  to.add<om::ModNormalFlippingT<Mesh>>().set_max_normal_deviation(number_of(spec, "angle"));
}

void add_normal_deviation(StockDecimater& to, const Spec& spec, const Scale&) {
  to.add<om::ModNormalDeviationT<Mesh>>().set_normal_deviation(number_of(spec, "angle"));
}

void add_aspect_ratio(StockDecimater& to, const Spec& spec, const Scale&) {
  to.add<om::ModAspectRatioT<Mesh>>().set_aspect_ratio(static_cast<float>(number_of(spec, "ratio")));
}

void add_edge_length(StockDecimater& to, const Spec& spec, const Scale& scale) {
  to.add<om::ModEdgeLengthT<Mesh>>().set_edge_length(spec.length("length", scale).value_or(1e30));
}

constexpr Length kHausdorff{0.5, Unit::percent};

void add_hausdorff(StockDecimater& to, const Spec& spec, const Scale& scale) {
  to.add<om::ModHausdorffT<Mesh>>().set_tolerance(
      spec.length("tolerance", scale).value_or(kHausdorff.in(scale)));
}

void add_roundness(StockDecimater& to, const Spec& spec, const Scale&) {
  to.add<om::ModRoundnessT<Mesh>>().set_min_roundness(number_of(spec, "min"), true);
}

void add_independent_sets(StockDecimater& to, const Spec&, const Scale&) {
  to.add<om::ModIndependentSetsT<Mesh>>();
}

}  // namespace

std::vector<Module> stock_modules() {
  return {
      quadric(),
      constraint("normal-flipping", "OpenMesh's ModNormalFlippingT",
                 {main_key(degrees_key("angle", "largest turn of a face normal", 90), Histogram::face_angle)},
                 add_normal_flipping),
      constraint("normal-deviation", "OpenMesh's ModNormalDeviationT",
                 {main_key(degrees_key("angle", "largest normal cone", 180, 360), Histogram::face_angle)},
                 add_normal_deviation),
      constraint(
          "aspect-ratio", "OpenMesh's ModAspectRatioT",
          {main_key(number_key("ratio", 1, HUGE_VAL, "largest aspect ratio of a triangle", {1, 20, 5}))},
          add_aspect_ratio),
      constraint("edge-length", "OpenMesh's ModEdgeLengthT",
                 {main_key(length_key("length", "longest edge that may collapse", "no bound"),
                           Histogram::edge_length)},
                 add_edge_length),
      constraint("hausdorff", "OpenMesh's ModHausdorffT",
                 {main_key(length_key("tolerance", "largest one-sided distance",
                                      kHausdorff.text() + " of the diagonal"))},
                 add_hausdorff),
      constraint("roundness", "OpenMesh's ModRoundnessT",
                 {main_key(number_key("min", 0, 1, "least roundness", {0, 1, 0.1}))}, add_roundness),
      constraint("independent-sets", "OpenMesh's ModIndependentSetsT: a collapse locks its ring", {},
                 add_independent_sets),
  };
}

}  // namespace whittle::recipe
