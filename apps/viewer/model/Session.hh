/// \file
/// All that the viewer works on, without a window: the model, the recipe and its history, and the workers.
#pragma once

#include <atomic>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "model/Comparer.hh"
#include "model/History.hh"
#include "model/Model.hh"
#include "model/RecipeEdit.hh"
#include "model/StandIn.hh"
#include "model/Worker.hh"

namespace whittle::viewer {

/// What poll() found.
struct News {
  bool model = false, outcome = false, comparison = false, plan = false;
  bool stand_ins = false;             ///< one of them, or both
  std::string written;                ///< the path of a result that has been exported; empty: none
  std::vector<std::string> left_out;  ///< what that file could not take, a line each
  bool any() const { return model || outcome || comparison || plan || stand_ins || !written.empty(); }
};

/// Every call returns at once; the work is done by threads, and poll() takes what they have finished.
class Session {
 public:
  /// \param wake  called on a worker's thread when there is something to poll; it may be empty.
  explicit Session(std::function<void()> wake = {});

  /// Begins to load a file. What is open stays until the new model is there; an error goes to errors().
  void open(const std::string& path);

  /// Goes to another recipe. Changes in a row with the same tag are undone together.
  void change(recipe::Recipe recipe, const std::string& tag = "");
  void end_of_drag() { history_.seal(); }
  void undo();
  void redo();
  const History<recipe::Recipe>& history() const { return history_; }
  const recipe::Recipe& recipe() const { return history_.now(); }
  const std::string& problem() const { return problem_; }  ///< why the recipe cannot be run; empty if it can

  /// Whether a change runs at once. If not, run() does it.
  void set_live(bool live);
  bool live() const { return live_; }
  void run();

  /// Whether results come out of one plan for all levels, where the recipe allows it: the first takes as long
  /// as ever, all others no time to plan.
  void set_levels(bool levels);
  bool levels() const { return levels_ && has_levels(recipe()); }

  /// The command that makes what is shown.
  /// \param out  where it writes
  std::string command(const std::string& out) const;

  /// Whether the plan of the recipe's first module is kept at hand.
  void set_plan_wanted(bool wanted);

  News poll();

  const Model* model() const { return model_.get(); }
  const Outcome* outcome() const { return outcome_.get(); }
  const Comparison* comparison() const;  ///< of the outcome; null until it is measured
  /// The histograms of a quantity; while a newer result is not measured yet, those with the one before it.
  const HistogramPair& histograms(Quantity quantity) const {
    return (comparison_ ? comparison_->histograms : model_->histograms)[static_cast<std::size_t>(quantity)];
  }
  const PlanPicture* plan() const { return plan_.get(); }
  /// What is drawn while the view moves, of a mesh that is too large to be drawn itself; null of others.
  /// \{
  const StandIn* model_stand_in() const { return model_stand_in_.get(); }
  const StandIn* outcome_stand_in() const { return outcome_stand_in_.get(); }
  /// \}
  bool outcome_is_current() const;  ///< it is that of the recipe as it stands

  bool loading() const { return !loader_.idle() || !loaded_.empty(); }
  bool decimating() const { return !decimator_.idle() || !decided_.empty(); }
  bool measuring() const { return !measurer_.idle() || !measured_.empty(); }
  bool planning() const { return !planner_.idle() || !planned_.empty(); }
  bool coarsening() const {  ///< stand-ins are being made
    return !model_coarsener_.idle() || !outcome_coarsener_.idle() || !model_coarse_.empty() ||
           !outcome_coarse_.empty();
  }
  bool writing() const { return !writer_.idle() || !written_.empty(); }
  bool settled() const {
    return !loading() && !decimating() && !measuring() && !planning() && !coarsening() && !writing();
  }
  recipe::Progress progress() const;  ///< of the decimation that runs
  /// The part that is done of what is under way, that is of loading, decimating, planning, writing,
  /// measuring, the first of these; none where it is not known.
  std::optional<double> part_done() const;

  /// Writes the result, at once or by a worker: what went wrong there goes to errors.
  /// \throw FileError
  /// \{
  void export_result(const std::string& path, bool ascii) const;
  void begin_export(const std::string& path, bool ascii);
  /// \}

  /// Lets the same worker write another file.
  /// \throw FileError  it is still writing one.
  /// \param write  returns what the file could not take.
  void begin_write(const std::string& path, std::function<std::vector<std::string>()> write);

  std::deque<std::string> errors;  ///< for the user to see, the oldest first

 private:
  struct Loaded {
    std::shared_ptr<const Model> model;
    std::string error;
  };
  struct Decided {
    std::shared_ptr<const Outcome> outcome;
    std::string error;
  };
  /// A stand-in with its mesh: one that arrives after its mesh was replaced is dropped.
  struct Coarse {
    const void* owner = nullptr;
    std::shared_ptr<const StandIn> stand_in;
  };
  struct Written {
    std::string path, error;
    std::vector<std::string> notes;
  };

  void recipe_has_changed();
  void start_plan();
  void take_model(Loaded loaded);
  void take_outcome(std::shared_ptr<const Outcome> outcome);
  void take_stand_ins(News& news);
  void ensure_measured();  ///< the outcome is measured, or is being measured
  void wake() const {
    if (wake_) wake_();
  }

  std::function<void()> wake_;
  History<recipe::Recipe> history_;
  std::string problem_;
  bool live_ = true, plan_wanted_ = false, levels_ = false;

  std::shared_ptr<const Model> model_;
  std::shared_ptr<Levels> all_levels_;  // of the model; only the decimator looks into it
  std::shared_ptr<const Outcome> outcome_;
  std::shared_ptr<const Comparison> comparison_;
  const Outcome* measured_outcome_ = nullptr;  ///< handed to the measurer, and not cancelled since
  std::shared_ptr<const PlanPicture> plan_;
  std::shared_ptr<const StandIn> model_stand_in_, outcome_stand_in_;

  mutable std::mutex progress_mutex_;
  recipe::Progress progress_;
  std::atomic<double> measured_part_{0};
  Comparer comparer_;
  Mailbox<Loaded> loaded_;
  Mailbox<Decided> decided_;
  Mailbox<std::shared_ptr<const PlanPicture>> planned_;
  Mailbox<std::shared_ptr<const Comparison>> measured_;
  Mailbox<Coarse> model_coarse_, outcome_coarse_;
  Mailbox<Written> written_;
  // The threads end before what they use.
  Worker loader_, decimator_, planner_, measurer_, model_coarsener_, outcome_coarsener_, writer_;
};

}  // namespace whittle::viewer
