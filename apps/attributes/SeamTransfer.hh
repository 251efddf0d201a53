/// \file
/// Texture coordinates through a decimation in which vertices move along seams.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "attributes/Attribute.hh"
#include "attributes/Sampler.hh"
#include "attributes/transfer.hh"
#include "whittle/plan/Patches.hh"
#include "whittle/plan/SeamPlaces.hh"
#include "whittle/surface/Lists.hh"

namespace whittle::attributes {

/// Carries one attribute of corners over so that nothing tears: a vertex takes its values where SeamPlaces says.
class SeamTransfer {
 public:
  SeamTransfer(const Attribute& in, const Decimation& d);
  Attribute run();

 private:
  void carry(std::uint32_t w);
  void keep(std::uint32_t v, detail::Lists::Range corners);

  const Attribute& in_;
  const Decimation& d_;
  Sampler sampler_;
  detail::Lists members_, corners_;
  detail::WedgedFaces input_;
  detail::SeamPlaces places_;
  std::vector<IndexedMesh::Triangle> wedges_, out_;
  std::vector<detail::SeamPlaces::Corner> merged_;  // at the current vertex
  std::map<std::uint32_t, std::uint32_t> known_;    // kept values there
};

}  // namespace whittle::attributes
