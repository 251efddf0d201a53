#include <functional>
#include <utility>

#include "speed/contenders/contenders.hh"
#include "whittle/openmesh/convert.hh"

namespace whittle::speed {
namespace {

/// Something done with the whole model that leaves nothing to score.
class WholeModel : public Contender {
 public:
  using Step = std::function<void(const Subject&, Arrays&, OpenMeshMesh&)>;
  explicit WholeModel(Step step) : step_(std::move(step)) {}

  void load(const Subject& subject) override { subject_ = &subject; }
  void decimate(Phases&) override { step_(*subject_, arrays_, mesh_); }
  Arrays unload() override { return {}; }

 private:
  Step step_;
  const Subject* subject_ = nullptr;
  Arrays arrays_;
  OpenMeshMesh mesh_;
};

Entry conversion(const char* method, const WholeModel::Step& step) {
  Entry e;
  e.method = method;
  e.in_place = true;
  e.make = [step] { return std::make_unique<WholeModel>(step); };
  return e;
}

}  // namespace

std::vector<Entry> conversion_entries() {
  return {conversion("copy of the arrays",
                     [](const Subject& s, Arrays& arrays, OpenMeshMesh&) { arrays = s.arrays; }),
          conversion("copy of the OpenMesh mesh",
                     [](const Subject& s, Arrays&, OpenMeshMesh& mesh) { mesh = s.mesh; }),
          conversion("arrays to OpenMesh",
                     [](const Subject& s, Arrays&, OpenMeshMesh& mesh) { build(s.arrays, mesh); }),
          conversion("OpenMesh to arrays",
                     [](const Subject& s, Arrays& arrays, OpenMeshMesh&) { arrays = to_indexed(s.mesh); })};
}

}  // namespace whittle::speed
