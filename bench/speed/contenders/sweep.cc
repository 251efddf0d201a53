#include "speed/contenders/planned.hh"
#include "whittle/SweepDecimaterT.hh"

namespace whittle::speed {

std::vector<Entry> sweep_entries(const Subject& subject) {
  return planned_entries<SweepDecimaterT<OpenMeshMesh>>("sweep", subject);
}

}  // namespace whittle::speed
