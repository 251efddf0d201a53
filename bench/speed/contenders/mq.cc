#include <memory>
#include <string>
#include <utility>

#include "speed/contenders/contenders.hh"
#include "whittle/bulk.hh"
#include "whittle/planners/MemorylessQuadric.hh"

namespace whittle::speed {
namespace {

/// mq needs no surface, and so has no phases.
class MqContender : public Contender {
 public:
  MqContender(const MemorylessQuadric& planner, std::size_t threads, bool refit) : planner_(planner) {
    options_.threads = threads;
    options_.refit = refit;
  }

  void load(const Subject& subject) override { arrays_ = &subject.arrays; }
  void decimate(Phases&) override { out_ = bulk(planner_, *arrays_, options_); }
  Arrays unload() override { return std::move(out_.mesh); }

 private:
  MemorylessQuadric planner_;
  BulkOptions options_;
  const Arrays* arrays_ = nullptr;
  BulkResultT<float> out_;
};

}  // namespace

std::vector<Entry> mq_entries(const std::vector<Target>& targets, std::size_t threads, bool refit) {
  std::vector<Entry> entries;
  for (const Target& target : targets) {
    MemorylessQuadric mq;
    mq.target_faces = target.faces;
    Entry& e = entries.emplace_back();
    e.method = "bulk";
    e.module = "mq";
    if (!refit) e.module += ", not refitted";
    if (threads > 0) e.module += ", threads: " + std::to_string(threads);
    e.in_place = true;
    e.target = target.name;
    e.target_faces = target.faces;
    e.make = [mq, threads, refit] { return std::make_unique<MqContender>(mq, threads, refit); };
  }
  return entries;
}

}  // namespace whittle::speed
