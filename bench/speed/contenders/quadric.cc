#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/McDecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <cstdlib>

#include "speed/contenders/OpenMeshContender.hh"
#include "speed/contenders/contenders.hh"
#include "whittle/LazyDecimaterT.hh"

namespace whittle::speed {
namespace {

namespace om = OpenMesh::Decimater;
using Mesh = OpenMeshMesh;

constexpr double kFlipDegrees = 90;  // a face may not turn over

/// ModNormalFlippingT complains where the mesh has no normals.
void request_normals(Mesh& mesh) {
  mesh.request_face_normals();
  mesh.update_face_normals();
}

template <typename Decimater>
Entry entry(const char* method, const Target& target, bool flipping) {
  const auto decimate = [faces = target.faces, flipping](Mesh& mesh) {
    Decimater decimater(mesh);
    add<om::ModQuadricT<Mesh>>(decimater).unset_max_err();
    if (flipping) add<om::ModNormalFlippingT<Mesh>>(decimater).set_max_normal_deviation(kFlipDegrees);
    decimater.initialize();
    std::srand(1);  // McDecimaterT draws with rand()
    decimater.decimate_to_faces(0, faces);
  };
  Entry e;
  e.method = method;
  e.module = flipping ? "quadric + normal-flipping" : "quadric";
  e.target = target.name;
  e.target_faces = target.faces;
  e.make = [decimate, flipping] {
    return std::make_unique<OpenMeshContender>(
        decimate, flipping ? OpenMeshContender::Step(request_normals) : OpenMeshContender::Step());
  };
  return e;
}

}  // namespace

std::vector<Entry> quadric_entries(const std::vector<Target>& targets) {
  // ModNormalFlippingT and McDecimaterT write to these streams, in every round.
  ::omerr().disable();
  ::omlog().disable();
  std::vector<Entry> entries;
  for (const Target& target : targets) {
    for (const bool flipping : {false, true}) {
      entries.push_back(entry<LazyDecimaterT<Mesh>>("lazy", target, flipping));
      entries.push_back(entry<om::DecimaterT<Mesh>>("DecimaterT", target, flipping));
      entries.back().heavy = true;
    }
    entries.push_back(entry<om::McDecimaterT<Mesh>>("McDecimaterT", target, false));
    entries.back().heavy = true;
  }
  return entries;
}

}  // namespace whittle::speed
