/// \file
/// The table of modules: all that the programs know about each, in one place. A new module is an entry here
/// (planned_modules.cc or stock_modules.cc) and, if it is Whittle's own, its planner.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "recipe/Planner.hh"
#include "recipe/Spec.hh"
#include "whittle/plan/TargetCount.hh"

namespace whittle::recipe {

/// What the value of a key looks like.
enum class KeyKind {
  length,   ///< `0.0012` model units, `0.8e` mean edges, `0.5%` of the bounding box's diagonal
  number,   ///< a plain number
  integer,  ///< a whole number
  choice    ///< one of a few words
};

/// What a plain number counts.
enum class Measure { none, degrees, square_units };

/// What a slider runs over, and where it stands while the key is not given: at the default, where that is a
/// number. Of lengths it depends on the mesh.
struct Slider {
  double low = 0, high = 0, start = 0;
  bool logarithmic = false;
  bool in_square_edges = false;  ///< low, high and start are in squares of the mean edge
};

/// The histogram on which a user of the viewer can pick the value of a key.
enum class Histogram { none, edge_length, face_angle };

struct Key {
  std::string name;
  KeyKind kind;
  std::string meaning;                    ///< one short phrase, with the unit
  std::string fallback;                   ///< what holds where the key is not given, in words
  double min = 0, max = 0;                ///< range of a number, both ends included
  std::vector<std::string> choices = {};  ///< the default first
  Measure measure = Measure::none;
  std::string instead_of = {};  ///< another key that says the same in another way, if there is one
  Slider slider = {};
  Histogram histogram = Histogram::none;
  bool is_main = false;  ///< the viewer shows it at once, the others on request

  std::string help() const { return meaning + "; " + fallback; }
};

/// How a module takes part in a recipe.
enum class Role {
  planned,    ///< a planner of Whittle's; begins a stage
  priority,   ///< a stock module that orders the collapses; begins a stage
  constraint  ///< a stock binary module; joins the stage before it
};

class StockDecimater;

/// An entry of the table.
struct Module {
  std::string name;
  Role role = Role::planned;
  std::string meaning;
  std::vector<Key> keys;

  /// The key that sets how far the module goes. Empty: it has no threshold, and goes to the target or until
  /// nothing is left to do.
  std::string threshold = {};
  bool ends_by_itself = false;  ///< goes a sensible way without threshold, target or bound
  bool refits = false;          ///< what it makes is refitted unless told otherwise
  bool cheapest_first = false;  ///< without a threshold, collapses in the order of the error it causes
  bool moves_seams = false;  ///< vertices merge along seams of texture; others hold them, or do so if asked
  bool plans_to_target = false;  ///< the planner knows the target, and tells nothing before it has planned
  /// The key of a bound on the distance to the input that the planner keeps by itself; empty: none.
  std::string bound = {};

  /// Of planned modules. \throw RecipeError  values that contradict each other.
  std::function<Planner(const Spec&, const Scale&, const TargetCount&)> make_planner = {};
  /// Of stock modules: adds the module to an OpenMesh decimater.
  std::function<void(StockDecimater&, const Spec&, const Scale&)> add = {};

  const Key* find(const std::string& key) const;  ///< null if there is none of that name
  /// Whether a spec gives a value to a key, or to one that says the same.
  bool is_given(const Spec& spec, const std::string& key) const;
  /// Whether it can do nothing without a target or a bound.
  bool needs_target() const { return threshold.empty() && !ends_by_itself && role != Role::constraint; }
};

/// All modules: planned ones, then those of OpenMesh that decimate, then the constraints.
const std::vector<Module>& catalogue();

/// \throw RecipeError  no such module; the message lists those that there are.
const Module& find_module(const std::string& name);

/// What runs where a recipe has a target or a bound, and no module.
Spec default_module();

/// Whether vertices merge along seams of texture: the module does so by itself, or is asked to.
bool moves_seams(const Spec& spec);

/// Whether the spec says how far to go.
bool has_threshold(const Spec& spec);

/// The specification with another threshold, which is a number in model units or degrees.
Spec with_threshold(Spec spec, double threshold);

/// The catalogue as text for `--help`.
std::string catalogue_help();

}  // namespace whittle::recipe
