/// \file
/// The modules that a recipe can name, with the keys that each understands.
#pragma once

#include <string>
#include <vector>

namespace whittle::recipe {

/// What the value of a key looks like.
enum class KeyKind {
  length,   ///< `0.0012` model units, `0.8e` mean edges, `0.5%` of the bounding box's diagonal
  number,   ///< a plain number
  integer,  ///< a whole number
  choice    ///< one of a few words
};

struct Key {
  std::string name;
  KeyKind kind;
  double min, max;                   ///< range of a number, both ends included
  std::vector<std::string> choices;  ///< of a choice
  std::string meaning;               ///< for help: one short phrase with unit and default
};

/// How a module takes part in a stage.
enum class Role {
  planned,    ///< a planner of Whittle's; begins a stage
  priority,   ///< a stock module that orders the collapses; begins a stage
  constraint  ///< a stock binary module; joins the stage before it
};

struct ModuleInfo {
  std::string name;
  Role role;
  std::string meaning;
  std::vector<Key> keys;
};

/// All modules, planned ones first.
const std::vector<ModuleInfo>& catalogue();

/// \throw RecipeError  no such module; the message lists those that there are.
const ModuleInfo& find_module(const std::string& name);

/// The catalogue as text for `--help`.
std::string catalogue_help();

}  // namespace whittle::recipe
