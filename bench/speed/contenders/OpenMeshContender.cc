#include "speed/contenders/OpenMeshContender.hh"

#include "whittle/compact.hh"
#include "whittle/openmesh/convert.hh"

namespace whittle::speed {

void OpenMeshContender::load(const Subject& subject) {
  mesh_ = subject.mesh;
  if (prepare_) prepare_(mesh_);
}

void OpenMeshContender::decimate(Phases&) {
  decimate_(mesh_);
}

Arrays OpenMeshContender::unload() {
  compact(mesh_);
  return to_indexed(mesh_);
}

}  // namespace whittle::speed
