#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/McDecimaterT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>
#include <algorithm>
#include <cstdlib>
#include <utility>

#include "recipe/OpenMeshCopy.hh"
#include "recipe/StockDecimater.hh"
#include "recipe/Stopwatch.hh"
#include "recipe/openmesh.hh"
#include "whittle/LazyDecimaterT.hh"
#include "whittle/SweepDecimaterT.hh"
#include "whittle/openmesh/ModPlannedT.hh"

namespace whittle::recipe {
namespace {

namespace om = OpenMesh::Decimater;
using Mesh = OpenMeshCopy::Mesh;

/// A binary module that allows everything and remembers what became of each vertex.
template <typename MeshT>
class ModRecordT : public om::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(ModRecordT, MeshT, Record);
  explicit ModRecordT(MeshT& mesh) : Base(mesh, true) {}
  void postprocess_collapse(const CollapseInfo& ci) override {
    collapses.emplace_back(ci.v0.idx(), ci.v1.idx());
  }
  std::vector<std::pair<int, int>> collapses;
};

/// A planner that has its plan already.
struct GivenPlan {
  const CollapsePlan* given = nullptr;

  void validate() const {}
  GivenPlan scaled(double) const { return *this; }
  template <typename Real>
  CollapsePlan plan(const SurfaceT<Real>&) const {
    return *given;
  }
};

template <typename MeshT>
class ModGivenPlanT : public ModPlannedT<MeshT, GivenPlan> {
 public:
  DECIMATING_MODULE(ModGivenPlanT, MeshT, GivenPlan);
  explicit ModGivenPlanT(MeshT& mesh) : ModPlannedT<MeshT, GivenPlan>(mesh) {}
};

/// A threshold that is f times as large lets errors count 1 / f^2 as much. Locked vertices need no weight.
StockDecimater::Weights add_weights(const SurfaceExtras& extras, Mesh& mesh) {
  StockDecimater::Weights weight;
  if (extras.tolerance.empty()) return weight;
  mesh.add_property(weight);
  for (const auto v : mesh.vertices()) {
    const float tolerance = extras.tolerance[static_cast<std::size_t>(v.idx())];
    mesh.property(weight, v) = tolerance > 0 ? 1 / (tolerance * tolerance) : 1.0f;
  }
  return weight;
}

/// Locks what must stay where it is. \param held  the flags of such vertices
void hold(const SurfaceExtras& extras, unsigned held, Mesh& mesh) {
  for (const auto v : mesh.vertices()) {
    const auto i = static_cast<std::size_t>(v.idx());
    const bool is_held = (!extras.flags.empty() && (extras.flags[i] & held) != 0) ||
                         (!extras.tolerance.empty() && extras.tolerance[i] == 0);
    if (is_held) mesh.status(v).set_locked(true);
  }
}

/// Lets the monitor end a decimation.
class Halt : public om::Observer {
 public:
  Halt(const Task& task, const Stage& stage, std::size_t faces)
      : Observer(1000), task_(task), stage_(stage), faces_(faces) {}
  void notify(std::size_t collapses) override {
    if (!task_.goes_on(stage_, faces_ - std::min(faces_, 2 * collapses))) called_ = true;
  }
  bool abort() const override { return called_; }

 private:
  const Task& task_;
  const Stage& stage_;
  std::size_t faces_;
  bool called_ = false;
};

template <typename Decimater>
void decimate(Decimater& decimater, const Mesh&, const TargetCount& target, const Halt&) {
  if (target.any())
    decimater.decimate_to_faces(target.vertices, target.faces);
  else
    decimater.decimate();
}

/// McDecimaterT draws half-edges with rand() and gives up after some 200 misses in a row, long before a plan
/// is done; so it is started again until a whole run finds nothing. From no half-edges at all it draws one
/// none the less.
void decimate(om::McDecimaterT<Mesh>& decimater, const Mesh& mesh, const TargetCount& target,
              const Halt& halt) {
  if (mesh.n_halfedges() == 0) return;
  std::srand(1);
  if (target.any())
    decimater.decimate_to_faces(target.vertices, target.faces);
  else
    while (!halt.abort() && decimater.decimate(mesh.n_vertices()) > 0) continue;
}

/// How many planned collapses were not executed; where the target is reached, how many of those before the
/// last that was.
std::size_t passed_over(const CollapsePlan& plan, const std::vector<std::pair<int, int>>& executed,
                        bool target_met) {
  if (!target_met) return plan.collapses.size() - executed.size();
  std::vector<std::uint32_t> gone;
  gone.reserve(executed.size());
  for (const auto& [from, to] : executed) gone.push_back(static_cast<std::uint32_t>(from));
  std::sort(gone.begin(), gone.end());
  const auto last = std::find_if(plan.collapses.rbegin(), plan.collapses.rend(), [&](const Collapse& c) {
    return std::binary_search(gone.begin(), gone.end(), c.from);
  });
  return static_cast<std::size_t>(plan.collapses.rend() - last) - executed.size();
}

/// \param plan  null: the stage's stock module orders the collapses
template <typename Decimater>
Decimated drive(const Task& task, const Stage& stage, const IndexedMesh& in, const SurfaceExtras& extras,
                const CollapsePlan* plan, StageResult& report) {
  const Silence silence;
  OpenMeshCopy copy(in);
  hold(extras, flags_that_hold({stage}), copy.mesh);
  // A plan that is alone leaves seams in their places, and is carried out as it is.
  const bool may_break_seams = moves_seams(stage.module) && (!plan || !stage.constraints.empty());
  if (may_break_seams && !extras.wedges.empty()) copy.set_wedges(in, extras.wedges);

  Decimater decimater(copy.mesh);
  StockDecimater modules(decimater, plan ? StockDecimater::Weights() : add_weights(extras, copy.mesh));
  const auto add = [&](const Spec& spec) { find_module(spec.name).add(modules, spec, task.scale); };
  if (plan)
    add_module<ModGivenPlanT<Mesh>>(decimater).set_planner({plan});
  else
    add(stage.module);
  for (const Spec& constraint : stage.constraints) add(constraint);
  const auto& record = modules.add<ModRecordT<Mesh>>();

  Halt halt(task, stage, in.triangles.size());
  decimater.set_observer(&halt);
  Stopwatch watch;
  decimater.initialize();
  decimate(decimater, copy.mesh, task.target, halt);
  if (halt.abort()) throw Cancelled();
  report.execute_seconds += watch.lap();

  Decimated out = copy.take(record.collapses);
  report.collapses += record.collapses.size();
  if (plan) report.refused_by_decimater += passed_over(*plan, record.collapses, task.is_target_met(out.mesh));
  return out;
}

Decimated drive_by_name(const Task& task, const Stage& stage, const IndexedMesh& mesh,
                        const SurfaceExtras& extras, const CollapsePlan* plan, StageResult& report) {
  if (stage.driver == Driver::sweep)
    return drive<SweepDecimaterT<Mesh>>(task, stage, mesh, extras, plan, report);
  if (stage.driver == Driver::lazy)
    return drive<LazyDecimaterT<Mesh>>(task, stage, mesh, extras, plan, report);
  if (stage.driver == Driver::mc)
    return drive<om::McDecimaterT<Mesh>>(task, stage, mesh, extras, plan, report);
  return drive<om::DecimaterT<Mesh>>(task, stage, mesh, extras, plan, report);
}

}  // namespace

Decimated execute_by_openmesh(const Task& task, const Stage& stage, const IndexedMesh& mesh,
                              const SurfaceExtras& extras, const CollapsePlan& plan, StageResult& report) {
  return drive_by_name(task, stage, mesh, extras, &plan, report);
}

Decimated run_stock_modules(const Task& task, const Stage& stage, const IndexedMesh& mesh,
                            const SurfaceExtras& extras, StageResult& report) {
  ++report.passes;
  return drive_by_name(task, stage, mesh, extras, nullptr, report);
}

}  // namespace whittle::recipe
