/// \file
/// What takes part in the benchmark: one way to decimate one model.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "speed/Subject.hh"

namespace whittle::speed {

/// Seconds of the parts of a run, by name, in their order.
using Phases = std::vector<std::pair<std::string, double>>;

/// One run: `load`, `decimate`, `unload`, each once and each timed apart.
class Contender {
 public:
  Contender() = default;
  virtual ~Contender() = default;
  Contender(const Contender&) = delete;
  Contender& operator=(const Contender&) = delete;

  /// Brings the model into the contender's own form.
  virtual void load(const Subject& subject) = 0;
  /// The time that is compared. `phases` takes up parts of it, if any.
  virtual void decimate(Phases& phases) = 0;
  /// The result as arrays; empty where there is nothing to score.
  virtual Arrays unload() = 0;
};

/// A contender with its task.
struct Entry {
  std::string method;            ///< "sweep", "DecimaterT", "meshopt_simplify"
  std::string module;            ///< "vt", "quadric + normal-flipping"; empty where there is none
  std::string target;            ///< "50 %", "as vt"; empty where the module's threshold says how far to go
  std::size_t target_faces = 0;  ///< 0: none
  std::function<std::unique_ptr<Contender>()> make;

  bool heavy = false;     ///< so slow that large models get fewer rounds of it
  bool in_place = false;  ///< reads the subject's arrays where they are
  bool countable = true;  ///< takes its memory from operator new, so that it can be counted

  /// "sweep vt", "meshopt_simplify as vt", "lazy quadric 50 %": unique within a model.
  std::string name() const {
    std::string name = method;
    for (const std::string& part : {module, target})
      if (!part.empty()) name += " " + part;
    return name;
  }
};

/// A number of faces to reach, and what the results call it.
struct Target {
  std::string name;
  std::size_t faces;
};

}  // namespace whittle::speed
