#include <string>
#include <thread>
#include <utility>

#include "recipe/Stopwatch.hh"
#include "speed/contenders/contenders.hh"
#include "whittle/Chain.hh"
#include "whittle/Circumcenter.hh"
#include "whittle/FaceAngle.hh"
#include "whittle/MemorylessQuadric.hh"
#include "whittle/SphereScan.hh"
#include "whittle/VertexDistance.hh"
#include "whittle/VertexTripletDistance.hh"
#include "whittle/bulk.hh"
#include "whittle/execute.hh"

namespace whittle::speed {
namespace {

template <typename Planner>
class BulkContender : public Contender {
 public:
  explicit BulkContender(const Planner& planner) : planner_(planner) {}

  void load(const Subject& subject) override { arrays_ = &subject.arrays; }

  void decimate(Phases& phases) override {
    recipe::Stopwatch watch;
    CollapsePlan plan;
    {
      const SurfaceT<float> surface(*arrays_, {}, std::thread::hardware_concurrency());
      phases.emplace_back("surface", watch.lap());
      plan = planner_.plan(surface);
      phases.emplace_back("plan", watch.lap());
    }
    out_ = execute(plan, *arrays_);
    phases.emplace_back("execute", watch.lap());
  }

  Arrays unload() override { return std::move(out_.mesh); }

 private:
  Planner planner_;
  const Arrays* arrays_ = nullptr;
  ExecutedT<float> out_;
};

/// mq needs no surface, and so has no phases.
class MqContender : public Contender {
 public:
  MqContender(const MemorylessQuadric& planner, std::size_t threads) : planner_(planner) {
    options_.threads = threads;
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

template <typename ContenderOf, typename... Settings>
Entry entry_of(const std::string& module, const Settings&... settings) {
  Entry e;
  e.method = "bulk";
  e.module = module;
  e.in_place = true;
  e.make = [settings...] { return std::make_unique<ContenderOf>(settings...); };
  return e;
}

template <typename Planner>
Entry entry(const char* module, const Planner& planner) {
  return entry_of<BulkContender<Planner>>(module, planner);
}

}  // namespace

std::vector<Entry> bulk_entries(const Subject& subject) {
  VertexDistance ivdd;
  ivdd.max_distance = kDistanceInEdges * subject.mean_edge;
  SphereScan ss;
  ss.radius = kRadiusInEdges * subject.mean_edge;
  VertexTripletDistance vtd;
  vtd.max_distance = kDistanceInEdges * subject.mean_edge;
  return {entry("vt", Circumcenter()), entry("fad", FaceAngle()),
          entry("ivdd", ivdd),         entry("ss", ss),
          entry("vtd", vtd),           entry("fass", Chain<FaceAngle, SphereScan>{{FaceAngle(), ss}})};
}

std::vector<Entry> mq_entries(const std::vector<Target>& targets, std::size_t threads) {
  std::vector<Entry> entries;
  for (const Target& target : targets) {
    MemorylessQuadric mq;
    mq.target_faces = target.faces;
    entries.push_back(
        entry_of<MqContender>(threads == 0 ? "mq" : "mq, threads: " + std::to_string(threads), mq, threads));
    entries.back().target = target.name;
    entries.back().target_faces = target.faces;
  }
  return entries;
}

std::vector<Target> planned_faces(const Subject& subject) {
  std::vector<Target> faces;
  for (const Entry& e : bulk_entries(subject)) {
    const auto contender = e.make();
    contender->load(subject);
    Phases phases;
    contender->decimate(phases);
    faces.push_back({e.module, contender->unload().triangles.size()});
  }
  return faces;
}

}  // namespace whittle::speed
