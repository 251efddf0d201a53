#include <string>
#include <thread>
#include <utility>

#include "recipe/Stopwatch.hh"
#include "speed/contenders/contenders.hh"
#include "whittle/plan/execute.hh"
#include "whittle/planners/Chain.hh"
#include "whittle/planners/Circumcenter.hh"
#include "whittle/planners/FaceAngle.hh"
#include "whittle/planners/SphereScan.hh"
#include "whittle/planners/VertexDistance.hh"
#include "whittle/planners/Vtd.hh"

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

template <typename Planner>
Entry entry(const char* module, const Planner& planner) {
  Entry e;
  e.method = "bulk";
  e.module = module;
  e.in_place = true;
  e.make = [planner] { return std::make_unique<BulkContender<Planner>>(planner); };
  return e;
}

}  // namespace

std::vector<Entry> bulk_entries(const Subject& subject) {
  VertexDistance ivdd;
  ivdd.max_distance = kDistanceInEdges * subject.mean_edge;
  SphereScan ss;
  ss.radius = kRadiusInEdges * subject.mean_edge;
  Vtd vtd;
  vtd.max_distance = kDistanceInEdges * subject.mean_edge;
  return {entry("vt", Circumcenter()), entry("fad", FaceAngle()),
          entry("ivdd", ivdd),         entry("ss", ss),
          entry("vtd", vtd),           entry("fass", Chain<FaceAngle, SphereScan>{{FaceAngle(), ss}})};
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
