/// \file
/// The text form of a module with its parameters: `name[:key=value,...]`.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace whittle::recipe {

/// A specification that means nothing: unknown module, key, unit or driver, a number out of range. `what()`
/// is one line that names the culprit.
class RecipeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The sizes that relative lengths refer to, in model units.
struct Scale {
  double mean_edge = 0;
  double diagonal = 0;
};

/// A length as people write it: `0.0012` in model units, `0.8e` in mean edges, `0.5%` of the diagonal.
struct Length {
  double amount = 0;
  std::string unit;  ///< "", "e" or "%"

  double in(const Scale& scale) const;  ///< in model units
  std::string text() const;
};

/// \throw RecipeError  no number, not finite, negative, or another unit.
Length parse_length(const std::string& text);

/// A parsed `name[:key=value,...]`, e.g. `ivdd:distance=0.8e`.
struct Spec {
  std::string name;
  std::vector<std::pair<std::string, std::string>> parameters;  ///< in the order given, keys unique

  std::string text() const;  ///< back to the text form

  bool has(const std::string& key) const { return find(key) != nullptr; }
  std::optional<double> number(const std::string& key) const;
  std::optional<double> length(const std::string& key, const Scale& scale) const;  ///< in model units
  std::optional<std::string> word(const std::string& key) const;

 private:
  const std::string* find(const std::string& key) const;
};

/// Parses and checks against the catalogue: a Spec that comes out of here has only known keys with good
/// values. \throw RecipeError  malformed text, an unknown module, key or unit, a value that is out of range.
Spec parse_spec(const std::string& text);

}  // namespace whittle::recipe
