#include "speed/contenders/planned.hh"
#include "whittle/ModMemorylessQuadricT.hh"
#include "whittle/SweepDecimaterT.hh"

namespace whittle::speed {

std::vector<Entry> sweep_mq_entries(const std::vector<Target>& targets) {
  std::vector<Entry> entries;
  for (const Target& target : targets) {
    entries.push_back(planned_entry<SweepDecimaterT<OpenMeshMesh>, ModMemorylessQuadricT<OpenMeshMesh>>(
        "sweep", "mq", [faces = target.faces](auto& module) { module.set_target_faces(faces); }));
    entries.back().target = target.name;
    entries.back().target_faces = target.faces;
  }
  return entries;
}

}  // namespace whittle::speed
