#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/McDecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModAspectRatioT.hh>
#include <OpenMesh/Tools/Decimater/ModEdgeLengthT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModIndependentSetsT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalDeviationT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModRoundnessT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>
#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <type_traits>
#include <utility>

#include "recipe/Pass.hh"
#include "recipe/Stopwatch.hh"
#include "whittle/DelaunayFlips.hh"
#include "whittle/LazyDecimaterT.hh"
#include "whittle/ModGuardedQuadricT.hh"
#include "whittle/SweepDecimaterT.hh"
#include "whittle/openmesh/ModPlannedT.hh"

namespace whittle::recipe {
namespace {

namespace om = OpenMesh::Decimater;
struct Traits : OpenMesh::DefaultTraitsDouble {
  using TexCoord1D = double;  // holds the number of a wedge exactly
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

/// OpenMesh writes warnings to its own streams; the programs say what matters themselves, once.
class Silence {
 public:
  Silence() : errors_(::omerr().is_enabled()), log_(::omlog().is_enabled()) {
    ::omerr().disable();
    ::omlog().disable();
  }
  ~Silence() {
    if (errors_) ::omerr().enable();
    if (log_) ::omlog().enable();
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  bool errors_, log_;
};

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

/// Adds a module and gives access to it. The decimater owns it, so the handle need not live on.
template <typename Module, typename Decimater>
Module& add(Decimater& decimater) {
  typename Module::Handle handle;
  decimater.add(handle);
  return decimater.module(handle);
}

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

/// Adds a stock module, with the defaults that the catalogue names.
template <typename Decimater>
void add_stock(Decimater& decimater, const Spec& spec, const Scale& scale,
               OpenMesh::VPropHandleT<float> weights = OpenMesh::VPropHandleT<float>()) {
  if (spec.name == "quadric") {
    auto& module = add<ModGuardedQuadricT<Mesh>>(decimater);
    if (const auto error = spec.number("max-err")) module.set_max_err(*error, false);
    if (const auto weight = spec.number("boundary-weight")) module.set_boundary_weight(*weight);
    if (const auto min_cos = spec.number("guard")) module.set_flip_guard(*min_cos);
    module.set_weight(weights);
  } else if (spec.name == "normal-flipping") {
    add<om::ModNormalFlippingT<Mesh>>(decimater).set_max_normal_deviation(spec.number("angle").value_or(90));
  } else if (spec.name == "normal-deviation") {
    add<om::ModNormalDeviationT<Mesh>>(decimater).set_normal_deviation(spec.number("angle").value_or(180));
  } else if (spec.name == "aspect-ratio") {
    add<om::ModAspectRatioT<Mesh>>(decimater).set_aspect_ratio(
        static_cast<float>(spec.number("ratio").value_or(5)));
  } else if (spec.name == "edge-length") {
    add<om::ModEdgeLengthT<Mesh>>(decimater).set_edge_length(spec.length("length", scale).value_or(1e30));
  } else if (spec.name == "hausdorff") {
    add<om::ModHausdorffT<Mesh>>(decimater).set_tolerance(
        spec.length("tolerance", scale).value_or(0.005 * scale.diagonal));
  } else if (spec.name == "roundness") {
    add<om::ModRoundnessT<Mesh>>(decimater).set_min_roundness(spec.number("min").value_or(0.1), true);
  } else {
    add<om::ModIndependentSetsT<Mesh>>(decimater);
  }
}

/// An OpenMesh mesh of the faces that OpenMesh takes, and which input faces those are.
struct Loaded {
  Mesh mesh;
  std::vector<std::uint32_t> face_origin;
  std::size_t refused_faces = 0;
};

void load(const IndexedMesh& in, Loaded& out) {
  for (const auto& p : in.points) out.mesh.add_vertex(Mesh::Point(p[0], p[1], p[2]));
  for (std::uint32_t f = 0; f < in.triangles.size(); ++f) {
    const auto& t = in.triangles[f];
    const bool degenerate = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    const auto corner = [&](int i) { return Mesh::VertexHandle(static_cast<int>(t[i])); };
    if (!degenerate && out.mesh.add_face(corner(0), corner(1), corner(2)).is_valid())
      out.face_origin.push_back(f);
    else
      ++out.refused_faces;
  }
  out.mesh.request_vertex_status();
  out.mesh.request_edge_status();
  out.mesh.request_halfedge_status();
  out.mesh.request_face_status();
  out.mesh.request_face_normals();  // the stock normal modules complain where they are missing
  out.mesh.update_face_normals();
}

/// A threshold that is f times as large lets errors count 1 / f^2 as much. Locked vertices need no weight.
OpenMesh::VPropHandleT<float> add_weights(const SurfaceExtras& extras, Mesh& mesh) {
  OpenMesh::VPropHandleT<float> weight;
  if (extras.tolerance.empty()) return weight;
  mesh.add_property(weight);
  for (const auto v : mesh.vertices()) {
    const float tolerance = extras.tolerance[static_cast<std::size_t>(v.idx())];
    mesh.property(weight, v) = tolerance > 0 ? 1 / (tolerance * tolerance) : 1.0f;
  }
  return weight;
}

/// Locks what must stay where it is.
void hold(const SurfaceExtras& extras, Mesh& mesh) {
  for (const auto v : mesh.vertices()) {
    const auto i = static_cast<std::size_t>(v.idx());
    const bool is_held = (!extras.flags.empty() && extras.flags[i] != 0) ||
                         (!extras.tolerance.empty() && extras.tolerance[i] == 0);
    if (is_held) mesh.status(v).set_locked(true);
  }
}

/// The living vertices and faces in their old order.
void unload(const Loaded& loaded, const std::vector<std::pair<int, int>>& collapses, Pass& pass) {
  const Mesh& mesh = loaded.mesh;
  std::vector<std::uint32_t> survivor(mesh.n_vertices());
  std::iota(survivor.begin(), survivor.end(), 0u);
  for (auto c = collapses.rbegin(); c != collapses.rend(); ++c) survivor[c->first] = survivor[c->second];

  pass.vertex_map.resize(mesh.n_vertices());
  for (const auto v : mesh.all_vertices()) {
    if (mesh.status(v).deleted()) continue;
    pass.vertex_map[v.idx()] = static_cast<std::uint32_t>(pass.mesh.points.size());
    const auto& p = mesh.point(v);
    pass.mesh.points.emplace_back(p[0], p[1], p[2]);
  }
  for (std::size_t v = 0; v < survivor.size(); ++v) pass.vertex_map[v] = pass.vertex_map[survivor[v]];
  for (const auto f : mesh.all_faces()) {
    if (mesh.status(f).deleted()) continue;
    IndexedMesh::Triangle t{};
    int i = 0;
    for (const auto v : mesh.fv_range(f)) t[i++] = pass.vertex_map[v.idx()];
    pass.mesh.triangles.push_back(t);
    pass.face_origin.push_back(loaded.face_origin[f.idx()]);
  }
}

/// Lets a caller end a decimation.
class Halt : public om::Observer {
 public:
  Halt(std::size_t faces, const GoOn& go_on) : Observer(1000), faces_(faces), go_on_(go_on) {}
  void notify(std::size_t collapses) override {
    if (go_on_ && !go_on_(faces_ - std::min(faces_, 2 * collapses))) called_ = true;
  }
  bool abort() const override { return called_; }

 private:
  std::size_t faces_;
  const GoOn& go_on_;
  bool called_ = false;
};

template <typename Decimater>
void decimate(Decimater& decimater, const Mesh&, const Floor& floor, const Halt&) {
  if (floor.any())
    decimater.decimate_to_faces(floor.vertices, floor.faces);
  else
    decimater.decimate();
}

/// McDecimaterT draws half-edges with rand() and gives up after some 200 misses in a row, long before a plan
/// is done; so it is started again until a whole run finds nothing. From no half-edges at all it draws one
/// none the less.
void decimate(om::McDecimaterT<Mesh>& decimater, const Mesh& mesh, const Floor& floor, const Halt& halt) {
  if (mesh.n_halfedges() == 0) return;
  std::srand(1);
  if (floor.any())
    decimater.decimate_to_faces(floor.vertices, floor.faces);
  else
    while (!halt.abort() && decimater.decimate(mesh.n_vertices()) > 0) continue;
}

/// How many planned collapses were not executed; where the floor is reached, how many of those before the
/// last that was.
std::size_t passed_over(const CollapsePlan& plan, const std::vector<std::pair<int, int>>& executed,
                        bool floor_reached) {
  if (!floor_reached) return plan.collapses.size() - executed.size();
  std::vector<std::uint32_t> gone;
  for (const auto& [from, to] : executed) gone.push_back(static_cast<std::uint32_t>(from));
  std::sort(gone.begin(), gone.end());
  const auto last = std::find_if(plan.collapses.rbegin(), plan.collapses.rend(), [&](const Collapse& c) {
    return std::binary_search(gone.begin(), gone.end(), c.from);
  });
  return static_cast<std::size_t>(plan.collapses.rend() - last) - executed.size();
}

template <typename Decimater>
Pass drive(const IndexedMesh& in, const SurfaceExtras& extras, const Job& job, const CollapsePlan* plan) {
  const Silence silence;
  Pass pass;
  Loaded loaded;
  load(in, loaded);
  hold(extras, loaded.mesh);
  pass.refused_faces = loaded.refused_faces;

  Decimater decimater(loaded.mesh);
  if (plan)
    add<ModGivenPlanT<Mesh>>(decimater).set_planner({plan});
  else
    add_stock(decimater, job.stage.module, job.scale, add_weights(extras, loaded.mesh));
  for (const Spec& constraint : job.stage.constraints) add_stock(decimater, constraint, job.scale);
  const auto& record = add<ModRecordT<Mesh>>(decimater);

  Halt halt(in.triangles.size(), job.go_on);
  decimater.set_observer(&halt);
  Stopwatch watch;
  decimater.initialize();
  decimate(decimater, loaded.mesh, job.floor, halt);
  if (halt.abort()) throw Cancelled();
  pass.execute_seconds = watch.lap();

  unload(loaded, record.collapses, pass);
  pass.collapses = record.collapses.size();
  if (plan) pass.refused = passed_over(*plan, record.collapses, job.floor.reached(pass.mesh));
  return pass;
}

}  // namespace

Pass openmesh_pass(const IndexedMesh& mesh, const SurfaceExtras& extras, const Job& job,
                   const CollapsePlan* plan) {
  if (job.driver == Driver::sweep) return drive<SweepDecimaterT<Mesh>>(mesh, extras, job, plan);
  if (job.driver == Driver::lazy) return drive<LazyDecimaterT<Mesh>>(mesh, extras, job, plan);
  if (job.driver == Driver::mc) return drive<om::McDecimaterT<Mesh>>(mesh, extras, job, plan);
  return drive<om::DecimaterT<Mesh>>(mesh, extras, job, plan);
}

IndexedMesh retriangulate(const IndexedMesh& mesh, double max_dihedral, DelaunayFlipsReport& report,
                          std::size_t& refused_faces, std::vector<IndexedMesh::Triangle>& wedges) {
  const Silence silence;
  Loaded loaded;
  load(mesh, loaded);
  refused_faces += loaded.refused_faces;
  if (!wedges.empty()) {
    loaded.mesh.request_halfedge_texcoords1D();
    for (const auto f : loaded.mesh.faces())
      for (const auto h : f.halfedges()) {
        const std::uint32_t old = loaded.face_origin[static_cast<std::size_t>(f.idx())];
        for (std::size_t k = 0; k < 3; ++k)
          if (mesh.triangles[old][k] == static_cast<std::uint32_t>(h.to().idx()))
            loaded.mesh.set_texcoord1D(h, wedges[old][k]);
      }
  }
  DelaunayFlips options;
  options.max_dihedral = max_dihedral;
  report = delaunay_flips(loaded.mesh, options);
  if (!wedges.empty()) {
    wedges.clear();
    for (const auto f : loaded.mesh.faces()) {
      auto& corners = wedges.emplace_back();
      std::size_t k = 0;  // unload() goes around the face from the same corner
      for (const auto v : loaded.mesh.fv_range(f))
        for (const auto h : f.halfedges())
          if (h.to() == v) corners[k++] = static_cast<std::uint32_t>(loaded.mesh.texcoord1D(h));
    }
  }
  Pass out;
  unload(loaded, {}, out);
  return std::move(out.mesh);
}

}  // namespace whittle::recipe
