#include "batch/Batch.hh"

#include <poll.h>

#include <cmath>
#include <list>
#include <optional>
#include <system_error>
#include <utility>

#include "batch/Claim.hh"
#include "batch/Memory.hh"

namespace whittle::batch {
namespace {

/// One mesh under way.
struct Running {
  std::size_t item;
  Claim claim;
  Child child;
};

Outcome judge(const Ending& ending, const Memory& memory, const Item& item) {
  Outcome outcome;
  outcome.seconds = ending.seconds;
  outcome.message = ending.message;
  constexpr int kMissed = 1;
  if (ending.succeeded() || (ending.how == Ending::How::exited && ending.code == kMissed)) {
    outcome.status = ending.succeeded() ? Outcome::Status::done : Outcome::Status::missed;
    memory.keep(item, outcome);
    return outcome;
  }
  outcome.status = Outcome::Status::failed;
  if (ending.how == Ending::How::timed_out)
    outcome.message = "out of time after " + std::to_string(std::lround(ending.seconds)) + " s";
  if (ending.how == Ending::How::signalled)
    outcome.message = "killed by signal " + std::to_string(ending.code);
  memory.forget_work(item);
  return outcome;
}

/// Waits until a child writes or ends, at most a tenth of a second.
void wait(const std::list<Running>& running) {
  std::vector<pollfd> descriptors;
  for (const Running& one : running) descriptors.push_back({one.child.descriptor(), POLLIN, 0});
  // A child that has closed its pipe but not yet ended would end every wait at once.
  ::poll(descriptors.data(), descriptors.size(), 20);
}

class Run {
 public:
  Run(const Order& order, const Report& report) : order_(order), report_(report), memory_(order) {
    outcomes_.resize(order.items.size());
  }

  std::vector<Outcome> all(const std::function<bool()>& interrupted) {
    auto touched = std::chrono::steady_clock::now();
    while (!interrupted()) {
      while (running_.size() < order_.jobs && next_ < order_.items.size()) begin(next_++);
      if (running_.empty()) break;
      wait(running_);
      collect();
      const auto now = std::chrono::steady_clock::now();
      if (now - touched < Claim::kLife / 6) continue;
      touched = now;
      for (const Running& one : running_) one.claim.touch();
    }
    for (const Running& one : running_) memory_.forget_work(order_.items[one.item]);
    return std::move(outcomes_);
  }

 private:
  void begin(std::size_t i) {
    const Item& item = order_.items[i];
    Outcome outcome;
    outcome.status = Outcome::Status::skipped;
    if (order_.resume && memory_.knows(item, outcome)) return end(i, outcome, false);
    outcome.status = Outcome::Status::elsewhere;
    std::optional<Claim> claim = Claim::take(memory_.claim(item));
    if (!claim) return end(i, outcome, false);
    outcome.status = Outcome::Status::skipped;  // it may have been finished just before it was claimed
    if (order_.resume && memory_.knows(item, outcome)) return end(i, outcome, false);
    std::filesystem::create_directories(item.out.parent_path());
    std::vector<std::string> command{order_.program,    "simplify", item.in.string(),
                                     item.out.string(), "--json",   memory_.work(item).string(),
                                     "--quiet"};
    command.insert(command.end(), order_.arguments.begin(), order_.arguments.end());
    running_.push_back({i, std::move(*claim), Child(command, order_.limits)});
  }

  void collect() {
    for (auto one = running_.begin(); one != running_.end();) {
      const std::optional<Ending> ending = one->child.poll();
      if (!ending) {
        ++one;
        continue;
      }
      const std::size_t item = one->item;
      const Outcome outcome = judge(*ending, memory_, order_.items[item]);
      one = running_.erase(one);  // gives the claim back
      end(item, outcome, true);
    }
  }

  void end(std::size_t i, const Outcome& outcome, bool worked) {
    outcomes_[i] = outcome;
    if (worked) memory_.log(order_.items[i], outcome);
    report_(++ended_, order_.items[i], outcome);
  }

  const Order& order_;
  const Report& report_;
  const Memory memory_;
  std::list<Running> running_;
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
