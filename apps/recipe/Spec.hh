/// \file
/// The text form of a module with its parameters: `name[:key=value,...]`.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace whittle::recipe {

/// A recipe that cannot be run: an unknown module, key, unit or driver, a number out of range, parts that do
/// not fit together. `what()` is one line that names the culprit.
class RecipeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A length that is measured when it is asked for first, as that takes as long as a good part of a decimation.
class LateLength {
 public:
  LateLength(double length = 0) : length_(length) {}
  explicit LateLength(std::function<double()> measure) : late_(std::make_shared<Late>()) {
    late_->measure = std::move(measure);
  }
  operator double() const {
    if (!late_) return length_;
    std::call_once(late_->once, [this] { late_->length = late_->measure(); });
    return late_->length;
  }

 private:
  struct Late {
    std::once_flag once;
    std::function<double()> measure;
    double length = 0;
  };
  double length_ = 0;
  std::shared_ptr<Late> late_;
};

/// The sizes that relative lengths refer to, in model units.
struct Scale {
  LateLength mean_edge;
  double diagonal = 0;  ///< of the bounding box
};

/// What a length is measured in.
enum class Unit {
  model,   ///< model units: `0.0012`
  edges,   ///< mean edge lengths: `0.8e`
  percent  ///< percent of the bounding box's diagonal: `0.5%`
};
const char* suffix(Unit unit);  ///< "", "e" or "%"

/// A length as people write it.
struct Length {
  double amount = 0;
  Unit unit = Unit::model;

  double in(const Scale& scale) const;  ///< in model units
  std::string text() const;
};

/// \throw RecipeError  no number, not finite, negative, or an unknown unit.
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

  /// Gives a key a value, or another one. \pre the key is one of the module's and takes the value
  void set(const std::string& key, const std::string& value);
  void clear(const std::string& key);  ///< back to the default

 private:
  const std::string* find(const std::string& key) const;
};

/// Parses and checks against the catalogue: a Spec that comes out of here has only known keys with good
/// values. \throw RecipeError  malformed text, an unknown module, key or unit, a value that is out of range.
Spec parse_spec(const std::string& text);

}  // namespace whittle::recipe
