/// \file
/// A contender that works on an OpenMesh mesh.
#pragma once

#include <functional>
#include <utility>

#include "speed/Contender.hh"

namespace whittle::speed {

/// Each run gets a fresh copy of the mesh. The living part of it is the result.
class OpenMeshContender : public Contender {
 public:
  using Step = std::function<void(OpenMeshMesh&)>;

  /// \param prepare  is not timed with the decimation; may be empty.
  explicit OpenMeshContender(Step decimate, Step prepare = {})
      : decimate_(std::move(decimate)), prepare_(std::move(prepare)) {}

  void load(const Subject& subject) override;
  void decimate(Phases& phases) override;
  Arrays unload() override;

 private:
  OpenMeshMesh mesh_;
  Step decimate_, prepare_;
};

/// Adds a module and gives access to it. The decimater owns it, so the handle need not live on.
template <typename Module, typename Decimater>
Module& add(Decimater& decimater) {
  typename Module::Handle handle;
  decimater.add(handle);
  return decimater.module(handle);
}

}  // namespace whittle::speed
