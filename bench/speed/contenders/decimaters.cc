#include <OpenMesh/Tools/Decimater/DecimaterT.hh>

#include "speed/contenders/planned.hh"
#include "whittle/LazyDecimaterT.hh"

namespace whittle::speed {

std::vector<Entry> planned_decimater_entries(const Subject& subject) {
  auto entries = planned_entries<LazyDecimaterT<OpenMeshMesh>>("lazy", subject);
  for (Entry& stock : planned_entries<OpenMesh::Decimater::DecimaterT<OpenMeshMesh>>("DecimaterT", subject)) {
    stock.heavy = true;
    entries.push_back(std::move(stock));
  }
  return entries;
}

}  // namespace whittle::speed
