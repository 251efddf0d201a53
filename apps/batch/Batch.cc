#include "batch/Batch.hh"

#include <poll.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <optional>
#include <system_error>
#include <utility>

#include "batch/Claim.hh"
#include "batch/Memory.hh"
#include "files/MeshFile.hh"

namespace whittle::batch {
namespace {

/// One mesh under way.
struct Running {
  std::size_t item;
  Claim claim;
  std::string input_stamp;
  Child child;
};

/// One that is to be begun.
struct Candidate {
  std::size_t item;
  Bid bid;
};

Outcome failure(const std::string& message) {
  Outcome outcome;
  outcome.status = Outcome::Status::failed;
  outcome.message = message;
  return outcome;
}

/// What the program said of a mesh, without its own name and the mesh's, which stand before it anyway.
std::string without_names(std::string message, const Item& item) {
  const auto take = [&](const std::string& beginning) {
    if (message.rfind(beginning, 0) != 0) return false;
    message.erase(0, beginning.size());
    return true;
  };
  take("whittle: ");
  if (take(item.in.string() + ":") && !take(" ")) message.insert(0, "line ");
  return message;
}

/// Too many processes or open files: not the fault of a mesh.
bool is_shortage(const std::error_code& error) {
  return error == std::errc::too_many_files_open || error == std::errc::too_many_files_open_in_system ||
         error == std::errc::resource_unavailable_try_again || error == std::errc::not_enough_memory;
}

/// A path that begins with a minus would be taken for an option.
std::string argument(const std::filesystem::path& path) {
  const std::string text = path.string();
  return text.rfind('-', 0) == 0 ? "./" + text : text;
}

/// Waits until a child writes or ends, for a moment at most.
void wait(const std::list<Running>& running) {
  std::vector<pollfd> descriptors;
  for (const Running& one : running) descriptors.push_back({one.child.descriptor(), POLLIN, 0});
  // A child that has closed its pipe but not yet ended would end every wait at once.
  ::poll(descriptors.data(), descriptors.size(), 20);
}

/// Tells when a time has passed, again and again.
class Interval {
 public:
  explicit Interval(std::chrono::milliseconds length) : length_(length) {}
  bool passed() {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < length_) return false;
    last_ = now;
    return true;
  }

 private:
  std::chrono::milliseconds length_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

class Run {
 public:
  Run(const Order& order, const Report& report)
      : order_(order), report_(report), memory_(order), jobs_(order.jobs) {
    outcomes_.resize(order.items.size());
  }

  std::vector<Outcome> all(const std::function<bool()>& interrupted) {
    Interval touch(Claim::kLife / 6), look(std::chrono::milliseconds(250));
    while (!interrupted()) {
      for (; running_.size() < jobs_ && next_ < order_.items.size(); ++next_)
        begin({next_, Bid(memory_.claim(order_.items[next_]))});
      if (running_.empty() && waiting_.empty() && next_ == order_.items.size()) break;
      wait(running_);
      collect();
      if (look.passed()) look_at_waiting();
      if (touch.passed())
        for (const Running& one : running_) one.claim.touch();
    }
    while (!running_.empty()) {
      const std::size_t item = running_.front().item;
      running_.pop_front();  // ends the child, which would go on writing
      memory_.forget_work(order_.items[item], process_name());
    }
    return std::move(outcomes_);
  }

 private:
  void begin(Candidate one) {
    Outcome outcome;
    const std::size_t i = one.item;
    try {
      if (try_begin(one, outcome)) return;
    } catch (const std::system_error& error) {
      if (is_shortage(error.code()) && !running_.empty()) {
        jobs_ = running_.size();
        waiting_.push_back(std::move(one));
        return;
      }
      outcome = failure(error.what());
    } catch (const std::exception& error) {
      outcome = failure(error.what());
    }
    end(i, outcome);
  }

  /// \return false where it is done or cannot be done: `outcome` says why
  bool try_begin(Candidate& one, Outcome& outcome) {
    const Item& item = order_.items[one.item];
    if (order_.resume && memory_.knows(item, outcome)) {
      clear_away(one, item);
      return false;
    }
    std::optional<Claim> claim = one.bid.take();
    if (!claim && !one.bid.owner_lives()) {
      waiting_.push_back(std::move(one));
      return true;
    }
    outcome.status = Outcome::Status::elsewhere;
    if (!claim) return false;
    if (!claim->previous_owner().empty()) memory_.forget_work(item, claim->previous_owner());
    // It may have been finished just before it was claimed.
    if (order_.resume && memory_.knows(item, outcome)) return false;
    std::filesystem::create_directories(item.out.parent_path());
    files::check_creatable(item.out);
    std::vector<std::string> command{order_.program,
                                     "simplify",
                                     argument(item.in),
                                     argument(memory_.result(item)),
                                     "--final-out=" + item.out.string(),
                                     "--json=" + argument(memory_.report(item)),
                                     "--quiet"};
    command.insert(command.end(), order_.arguments.begin(), order_.arguments.end());
    std::string stamp = memory_.input_stamp(item);
    running_.push_back({one.item, std::move(*claim), std::move(stamp), Child(command, order_.limits)});
    return true;
  }

  /// Removes what an owner leaves that died between the result and the end of its claim, where that can be done.
  void clear_away(Candidate& one, const Item& item) {
    try {
      if (!std::filesystem::exists(memory_.claim(item))) return;
      const std::optional<Claim> claim = one.bid.take();
      if (claim && !claim->previous_owner().empty()) memory_.forget_work(item, claim->previous_owner());
    } catch (const std::filesystem::filesystem_error&) {  // as in a folder that cannot be written to
      return;
    }
  }

  void look_at_waiting() {
    std::list<Candidate> again;
    again.swap(waiting_);
    for (Candidate& one : again) {
      if (running_.size() < jobs_)
        begin(std::move(one));
      else
        waiting_.push_back(std::move(one));
    }
  }

  void collect() {
    for (auto one = running_.begin(); one != running_.end();) {
      const std::optional<Ending> ending = one->child.poll();
      if (!ending) {
        ++one;
        continue;
      }
      const std::size_t item = one->item;
      Outcome outcome = judge(*ending, *one);
      memory_.forget_work(order_.items[item], process_name());
      running_.erase(one++);  // gives the claim back
      outcome.logged = memory_.log(order_.items[item], outcome);
      end(item, outcome);
    }
  }

  Outcome judge(const Ending& ending, const Running& one) const {
    constexpr int kMissed = 1;
    Outcome outcome;
    if (ending.how == Ending::How::timed_out)
      outcome = failure("out of time after " + std::to_string(std::lround(ending.seconds)) + " s");
    else if (ending.how == Ending::How::signalled)
      outcome = failure("killed by signal " + std::to_string(ending.code));
    else if (ending.code != 0 && ending.code != kMissed)
      outcome = failure(without_names(ending.message, order_.items[one.item]));
    else
      outcome = keep(one, ending);
    outcome.seconds = ending.seconds;
    return outcome;
  }

  Outcome keep(const Running& one, const Ending& ending) const {
    const Item& item = order_.items[one.item];
    if (!one.claim.is_mine())
      return failure("another process has taken this one for dead and gone on with it");
    if (memory_.input_stamp(item) != one.input_stamp) return failure("the input has changed meanwhile");
    Outcome outcome;
    outcome.status = ending.succeeded() ? Outcome::Status::done : Outcome::Status::missed;
    // Where all is well, it is in the notes.
    if (!ending.succeeded()) outcome.message = without_names(ending.message, item);
    try {
      memory_.keep(item, one.input_stamp, outcome);
    } catch (const std::exception& error) {
      return failure(error.what());
    }
    return outcome;
  }

  void end(std::size_t i, const Outcome& outcome) {
    outcomes_[i] = outcome;
    report_(++ended_, order_.items[i], outcome);
  }

  const Order& order_;
  const Report& report_;
  const Memory memory_;
  std::size_t jobs_;
  std::list<Running> running_;
  std::list<Candidate> waiting_;  // claimed by a process that may be dead, or there was no room
  std::vector<Outcome> outcomes_;
  std::size_t next_ = 0, ended_ = 0;
};

}  // namespace
std::string to_string(Outcome::Status status) {
  switch (status) {
    case Outcome::Status::done:
      return "done";
    case Outcome::Status::missed:
      return "target missed";
    case Outcome::Status::failed:
      return "failed";
    case Outcome::Status::skipped:
      return "done before";
    case Outcome::Status::missed_before:
      return "target missed before";
    case Outcome::Status::elsewhere:
      return "in work elsewhere";
    default:
      return "unfinished";
  }
}

std::vector<Outcome> run(const Order& order, const Report& report, const std::function<bool()>& interrupted) {
  try {
    return Run(order, report).all(interrupted);
  } catch (const std::filesystem::filesystem_error& error) {
    throw BatchError(error.what());
  }
}

}  // namespace whittle::batch
