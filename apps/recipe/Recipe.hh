/// \file
/// A recipe says what is done to a mesh: a chain of modules with their parameters, and a target.
///
/// The command line, the benchmark and the viewer all run meshes through this type, so their numbers agree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "attributes/Attribute.hh"
#include "attributes/transfer.hh"
#include "measure/Distance.hh"
#include "recipe/Decimated.hh"
#include "recipe/Spec.hh"
#include "whittle/DelaunayFlips.hh"
#include "whittle/plan/CollapsePlan.hh"
#include "whittle/plan/attainable.hh"
#include "whittle/refit.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Surface.hh"

namespace whittle::recipe {

/// Who executes the plans. `automatic`: bulk for planned modules alone, sweep for planned modules with
/// constraints, lazy for stock priority modules. `decimater` and `mc` are OpenMesh's own.
enum class Driver { automatic, bulk, sweep, lazy, decimater, mc };

/// A driver as recipes name it, and what it is, in a few words.
struct DriverInfo {
  Driver driver;
  const char* name;
  const char* meaning;
};
const std::vector<DriverInfo>& drivers();

/// The driver of that name. \throw RecipeError
Driver parse_driver(const std::string& name);
std::string to_string(Driver driver);

/// When to stop; without any, each module goes as far as its threshold takes it.
struct Target {
  std::optional<double> ratio;          ///< of the faces, in (0, 1]; with 1 the mesh stays as it is
  std::optional<std::size_t> faces;     ///< at most this many
  std::optional<std::size_t> vertices;  ///< at most this many
  bool any() const { return ratio || faces || vertices; }
};

/// Which pieces of a mesh, parts that share no vertex, may vanish as a whole. The largest always stays, and
/// so do those with a vertex that is locked.
struct PieceRule {
  enum class What {
    keep,      ///< none
    by_error,  ///< those that cost less than what else would have to go to reach the target
    below      ///< those whose bounding box has a diagonal below `length`
  };
  What what = What::keep;
  Length length = {};

  std::string text() const;  ///< "keep", "by-error", or the length
};

/// \throw RecipeError  neither a rule nor a length above 0
PieceRule parse_pieces(const std::string& text);

/// What is done to a mesh. The modules make stages that run one after the other: each module that decimates
/// begins one, and stock binary modules constrain the one before them.
struct Recipe {
  std::vector<Spec> modules;  ///< in order; none: only the pieces below a length vanish
  Target target;
  /// A bound on the two-sided distance to the input, sampled as measure::distance does. It holds for every
  /// module; where the target cannot be reached within it, the target is missed. A module without threshold
  /// or target goes as far as the bound allows.
  std::optional<Length> max_distance;
  std::size_t samples =
      measure::DistanceOptions().samples;  ///< for that bound, on each side, besides the vertices
  Driver driver = Driver::automatic;
  PieceRule pieces;
  /// Go on to the target where what cannot vanish, small pieces and held vertices, leaves the rest less than half of its
  /// share. Otherwise the run stops where the rest has its share.
  bool force = false;
  /// Retriangulate the result by Delaunay flips of edges no sharper than so many degrees, 0..180 (Paper 1,
  /// the end of every algorithm). Without a value: leave it.
  std::optional<double> delaunay;
  /// Move the vertices of the result to where its faces lie closest to the input; before a retriangulation. Without a
  /// value: where the last module is mq and nothing bounds the distance.
  std::optional<bool> refit;
};

/// What one stage did.
struct StageResult {
  std::string module;                 ///< the specification as it was run, thresholds filled in
  Driver driver = Driver::automatic;  ///< the one that ran
  std::size_t passes = 0;
  std::size_t faces_before = 0, faces_after = 0;
  PlanRecord record;          ///< clusters planned and refused; empty for stock modules
  std::size_t collapses = 0;  ///< executed
  std::size_t refused_by_decimater =
      0;  ///< planned collapses that the driver found illegal or a constraint refused
  double plan_seconds = 0, execute_seconds = 0;
};

/// The mesh that a recipe leaves, where its parts come from, and how that went. After a retriangulation faces
/// are no longer those of the input, and `face_origin` is empty.
struct Result : Decimated {
  static constexpr std::uint32_t kNoVertex = 0xffffffffu;  ///< in `vertex_map`: its piece has vanished
  attributes::Attributes attributes;                       ///< of `mesh`, where some were given
  std::vector<std::uint32_t> parts;                        ///< for each face of `mesh` its part; the same
  std::vector<StageResult> stages;
  std::optional<double> distance;  ///< largest distance to the input, model units, where there was a bound
  bool bound_held = true;          ///< false: faces that OpenMesh could not take are missing, and lie too far
  std::size_t held_by_bound = 0;   ///< input vertices that were kept in place for the bound's sake
  std::size_t held = 0;            ///< input vertices that the givens keep in place
  std::size_t held_on_seams = 0;   ///< of those, the ones that are only on a seam that no module moves
  std::size_t charts = 0;          ///< of the input, which seams enclose; 0 where there are none
  std::size_t charts_gone = 0;     ///< of those, how many have no face left
  std::size_t pieces_gone = 0, faces_of_pieces_gone = 0;
  Attainable attainable;  ///< the target that was gone to; raised where the one given would have ruined
                          ///< what is free
  bool stopped_by_bound = false;         ///< going on would have broken the bound
  bool retriangulation_dropped = false;  ///< it would have broken the bound
  std::optional<RefitReport> refit;      ///< if there was one
  bool refit_dropped = false;            ///< it would have broken the bound
  double refit_seconds = 0;
  DelaunayFlipsReport delaunay;   ///< of the retriangulation, if there was one
  std::size_t flipped_faces = 0;  ///< faces turned by more than 90 degrees against their own original normal,
                                  ///< before the retriangulation
  bool target_reached = true;     ///< false: see reasons()

  double seconds() const;  ///< that planning, execution and refit took
};

/// What a run respects besides the recipe; every part may be empty.
struct Givens {
  std::vector<std::uint8_t> flags;  ///< for each vertex: kLocked or kFeature keep it in place
  std::vector<float> tolerance;     ///< for each vertex a factor of the thresholds, see SurfaceExtras
  /// To be carried over. Seams of texture coordinates move in modules that can move them, and stay in others
  const attributes::Attributes* attributes = nullptr;
  attributes::SeamKinds seams = {};  ///< what makes seams besides texture coordinates
  /// For each face a number: between different ones, as those of materials, there is a seam
  std::vector<std::uint32_t> areas = {};
  /// What lengths in percent refer to, where the mesh's own bounding box says nothing of it; model units. 0: that box
  double diagonal = 0;
  const std::vector<std::uint32_t>* parts = nullptr;  ///< for each face the part that it is of; carried over
};

/// The sizes that the relative lengths of a recipe refer to. Each edge counts once in the mean.
/// \throw InvalidMesh  an index out of range.
Scale measure_scale(const IndexedMesh& mesh);

/// Where a run is.
struct Progress {
  std::size_t stage = 0, stages = 1;  ///< which one runs, counted from 0
  std::size_t faces = 0;              ///< left so far
};

/// Follows a run and may end it: called now and then on the thread that runs; false ends it with Cancelled.
using Monitor = std::function<bool(const Progress&)>;

/// A monitor ended the run.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

/// Whether a recipe's result is refitted.
bool wants_refit(const Recipe& recipe);

/// What a refit holds: what the givens hold, and the seams of their attributes.
std::vector<std::uint8_t> held_in_refit(const IndexedMesh& mesh, const Givens& givens);

/// What makes seams, as SurfaceExtras has it; empty where nothing does.
std::vector<IndexedMesh::Triangle> wedges_of(const Givens& givens);

/// For each face the part of the one that it was; empty where no parts were given.
std::vector<std::uint32_t> parts_of(const Givens& givens, const Decimated& result);

/// Finds what `run` would object to, without a mesh.
/// \throw RecipeError  no module, a constraint in first place, a driver that cannot run a module, neither
///                     threshold nor target nor bound, a ratio outside of (0, 1], an angle outside of
///                     [0, 180], pieces by error without a target.
void check(const Recipe& recipe);

/// Runs a recipe. The input is not changed. A target without a threshold makes the stage search for the
/// threshold.
/// \throw RecipeError  as check(). \throw InvalidMesh  an index out of range, a coordinate that is not
/// finite. \throw InvalidParameter  givens of another size than the mesh. \throw Cancelled  the monitor said
/// so.
Result run(const IndexedMesh& mesh, const Recipe& recipe, const Monitor& monitor = {},
           const Givens& givens = {});

/// What the first stage would do, before anything is executed: the collapses that `run` would carry out, or
/// offer to a driver with constraints, on the input. Empty for a stock module, which has no plan. A bound is
/// not looked at.
/// \throw  as run().
CollapsePlan plan(const IndexedMesh& mesh, const Recipe& recipe, const Monitor& monitor = {},
                  const Givens& givens = {});

/// Why a run could go no further, in a few words each; empty where the target was reached.
std::vector<std::string> reasons(const Recipe& recipe, const Result& result);

}  // namespace whittle::recipe
