#include "whittle/compact.hh"

#include "speed/contenders/OpenMeshContender.hh"
#include "speed/contenders/contenders.hh"
#include "whittle/ModVertexDistanceT.hh"
#include "whittle/SweepDecimaterT.hh"

namespace whittle::speed {

std::vector<Entry> compaction_entries(const Subject& subject) {
  const OpenMeshContender::Step decimate = [distance =
                                                kDistanceInEdges * subject.mean_edge](OpenMeshMesh& mesh) {
    SweepDecimaterT<OpenMeshMesh> decimater(mesh);
    add<ModVertexDistanceT<OpenMeshMesh>>(decimater).set_max_distance(distance);
    decimater.initialize();
    decimater.decimate();
  };
  const auto entry = [&](const char* method, const OpenMeshContender::Step& collect) {
    Entry e;
    e.method = method;
    e.module = "after ivdd";
    e.make = [collect, decimate] { return std::make_unique<OpenMeshContender>(collect, decimate); };
    return e;
  };
  return {entry("compact", [](OpenMeshMesh& mesh) { compact(mesh); }),
          entry("garbage_collection", [](OpenMeshMesh& mesh) { mesh.garbage_collection(); })};
}

}  // namespace whittle::speed
