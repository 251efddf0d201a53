#include "model/Session.hh"

#include <chrono>
#include <exception>
#include <new>
#include <thread>
#include <utility>

#include "model/RecipeEdit.hh"
#include "model/RecipeText.hh"
#include "model/progress.hh"

namespace whittle::viewer {
namespace {

/// How long an outcome must last before it is measured: while a slider moves, none does.
constexpr std::chrono::milliseconds kRest(120);

std::string reason(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) ? "not enough memory" : error.what();
}

std::vector<std::string> write_result(const std::string& path, const Outcome& outcome, bool ascii) {
  files::WriteOptions options;
  options.ascii = ascii;
  options.single_precision = outcome.model->file.single_precision;
  files::Parts parts = outcome.model->file.parts;
  parts.of_face = outcome.result.parts;
  return files::write_mesh(path, outcome.mesh(), options, outcome.result.attributes, parts).notes();
}

bool rests(const Wanted& wanted) {
  for (auto waited = kRest; waited.count() > 0; waited -= kRest / 12) {
    std::this_thread::sleep_for(kRest / 12);
    if (!wanted()) return false;
  }
  return true;
}

}  // namespace

Session::Session(std::function<void()> wake) : wake_(std::move(wake)), history_(first_recipe()) {}

void Session::open(const std::string& path) {
  loader_.submit([this, path](const Wanted& wanted) {
    Loaded loaded;
    try {
      loaded.model = load_model(path);
    } catch (const std::exception& error) {
      loaded.error = reason(error);
    }
    if (!wanted()) return;
    loaded_.put(std::move(loaded));
    wake();
  });
}

void Session::change(recipe::Recipe recipe, const std::string& tag) {
  history_.change(std::move(recipe), tag);
  recipe_has_changed();
}

void Session::undo() {
  history_.undo();
  recipe_has_changed();
}

void Session::redo() {
  history_.redo();
  recipe_has_changed();
}

void Session::set_live(bool live) {
  live_ = live;
  if (live_ && !outcome_is_current()) run();
}

void Session::set_levels(bool levels) {
  levels_ = levels;
  if (live_ && !outcome_is_current()) run();
}

std::string Session::command(const std::string& out) const {
  const std::string in = model_ ? model_->path : "IN";
  return levels() ? levels_command_text(recipe(), in, out) : command_text(recipe(), in, out);
}

void Session::recipe_has_changed() {
  problem_.clear();
  try {
    recipe::check(recipe());
  } catch (const std::exception& error) {
    problem_ = error.what();
  }
  if (live_) run();
  start_plan();
}

void Session::run() {
  decimator_.cancel();
  decided_.take();
  if (!model_) return;
  if (!problem_.empty()) return ensure_measured();
  measurer_.cancel();  // of what will be gone in a moment
  measured_.take();
  measured_outcome_ = nullptr;
  {
    const std::lock_guard lock(progress_mutex_);
    progress_ = {0, recipe().modules.size(), model_->mesh().triangles.size()};
  }
  const std::shared_ptr<Levels> levels = this->levels() ? all_levels_ : nullptr;
  decimator_.submit([this, levels, model = model_, recipe = recipe()](const Wanted& wanted) {
    Decided decided;
    try {
      const recipe::Monitor monitor = [&](const recipe::Progress& now) {
        const std::lock_guard lock(progress_mutex_);
        if (wanted()) progress_ = now;
        return wanted();
      };
      decided.outcome =
          levels ? make_level(model, recipe, *levels, monitor) : make_outcome(model, recipe, monitor);
    } catch (const recipe::Cancelled&) {
      return;
    } catch (const std::exception& error) {
      decided.error = reason(error);
    }
    if (!wanted()) return;
    decided_.put(std::move(decided));
    wake();
  });
}

void Session::set_plan_wanted(bool wanted) {
  if (std::exchange(plan_wanted_, wanted) == wanted) return;
  if (wanted)
    start_plan();
  else
    plan_.reset();
}

void Session::start_plan() {
  planner_.cancel();
  planned_.take();
  if (!plan_wanted_ || !model_ || !problem_.empty()) {
    plan_.reset();
    return;
  }
  planner_.submit([this, model = model_, recipe = recipe()](const Wanted& wanted) {
    auto plan = std::make_shared<PlanPicture>();
    try {
      const auto collapses = recipe::plan(
          model->mesh(), recipe, [&](const recipe::Progress&) { return wanted(); }, model->givens());
      *plan = picture(model->mesh(), collapses);
    } catch (const std::exception&) {  // cancelled; anything else the run itself reports
      return;
    }
    if (!wanted()) return;
    planned_.put(std::move(plan));
    wake();
  });
}

void Session::take_model(Loaded loaded) {
  if (!loaded.model) {
    errors.push_back(loaded.error);
    return;
  }
  model_ = std::move(loaded.model);
  all_levels_ = std::make_shared<Levels>();
  outcome_.reset();
  comparison_.reset();
  plan_.reset();
  model_stand_in_.reset();
  outcome_stand_in_.reset();
  outcome_coarsener_.cancel();
  measurer_.cancel();
  measured_.take();
  model_coarsener_.submit([this, model = model_](const Wanted& wanted) {
    auto stand_in = make_stand_in(model->mesh());
    if (!stand_in || !wanted()) return;
    model_coarse_.put({model.get(), std::move(stand_in)});
    wake();
  });
  recipe_has_changed();
}

void Session::take_outcome(std::shared_ptr<const Outcome> outcome) {
  outcome_ = std::move(outcome);
  outcome_stand_in_.reset();
  outcome_coarsener_.submit([this, made = outcome_](const Wanted& wanted) {
    if (!rests(wanted)) return;
    auto stand_in = make_stand_in(made->mesh());
    if (!stand_in || !wanted()) return;
    outcome_coarse_.put({made.get(), std::move(stand_in)});
    wake();
  });
  ensure_measured();
}

void Session::take_stand_ins(News& news) {
  const auto take = [&](Mailbox<Coarse>& mailbox, const void* owner, std::shared_ptr<const StandIn>& place) {
    auto coarse = mailbox.take();
    if (!coarse || coarse->owner != owner) return;
    place = std::move(coarse->stand_in);
    news.stand_ins = true;
  };
  take(model_coarse_, model_.get(), model_stand_in_);
  take(outcome_coarse_, outcome_.get(), outcome_stand_in_);
}

void Session::ensure_measured() {
  if (!outcome_ || comparison() || measured_outcome_ == outcome_.get()) return;
  measured_outcome_ = outcome_.get();
  measured_.take();
  measured_part_ = 0;
  measurer_.submit([this, outcome = outcome_](const Wanted& wanted) {
    if (!rests(wanted)) return;
    auto comparison = comparer_.compare(outcome, [&](double part) {
      measured_part_ = part;
      return wanted();
    });
    if (!comparison || !wanted()) return;
    measured_.put(std::move(comparison));
    wake();
  });
}

News Session::poll() {
  News news;
  if (auto loaded = loaded_.take()) {
    news.model = loaded->model != nullptr;
    take_model(std::move(*loaded));
  }
  if (auto decided = decided_.take()) {
    if (decided->outcome && decided->outcome->model == model_) {
      take_outcome(std::move(decided->outcome));
      news.outcome = true;
    } else if (!decided->outcome) {
      problem_ = decided->error;
      ensure_measured();
    }
  }
  if (auto measured = measured_.take()) {
    comparison_ = std::move(*measured);
    news.comparison = comparison() != nullptr;
  }
  if (auto planned = planned_.take()) {
    plan_ = std::move(*planned);
    news.plan = true;
  }
  take_stand_ins(news);
  if (auto written = written_.take()) {
    if (written->error.empty()) {
      news.written = written->path;
      news.left_out = std::move(written->notes);
    } else {
      errors.push_back(written->error);
    }
  }
  return news;
}

const Comparison* Session::comparison() const {
  return comparison_ && comparison_->outcome == outcome_ ? comparison_.get() : nullptr;
}

bool Session::outcome_is_current() const {
  return outcome_ && outcome_->from_levels == levels() &&
         options_text(outcome_->recipe) == options_text(recipe());
}

recipe::Progress Session::progress() const {
  const std::lock_guard lock(progress_mutex_);
  return progress_;
}

std::optional<double> Session::part_done() const {
  if (loading() || !model_) return std::nullopt;
  if (decimating()) return viewer::part_done(recipe(), progress(), model_->mesh().triangles.size());
  if (planning() || writing() || !measuring()) return std::nullopt;
  return measured_part_.load();
}

void Session::begin_export(const std::string& path, bool ascii) {
  if (!outcome_) throw files::FileError(path + ": there is no result to write yet");
  begin_write(path, [path, outcome = outcome_, ascii] { return write_result(path, *outcome, ascii); });
}

void Session::begin_write(const std::string& path, std::function<std::vector<std::string>()> write) {
  if (writing()) throw files::FileError(path + ": another file is being written");
  writer_.submit([this, path, write = std::move(write)](const Wanted&) {
    Written written{path, {}, {}};
    try {
      written.notes = write();
    } catch (const std::exception& error) {
      written.error = reason(error);
    }
    written_.put(std::move(written));
    wake();
  });
}

void Session::export_result(const std::string& path, bool ascii) const {
  if (!outcome_) throw files::FileError(path + ": there is no result to write yet");
  write_result(path, *outcome_, ascii);
}

}  // namespace whittle::viewer
