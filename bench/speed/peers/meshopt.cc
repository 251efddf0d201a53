#include <meshoptimizer.h>

#include <cfloat>
#include <memory>
#include <optional>

#include "speed/TargetSearch.hh"
#include "speed/peers/peers.hh"

namespace whittle::speed {
namespace {

using Indices = std::vector<unsigned int>;
constexpr float kAnyError = FLT_MAX;

const unsigned int* indices(const Arrays& arrays) {
  return arrays.triangles.front().data();
}
const float* coordinates(const Arrays& arrays) {
  return arrays.points.front().data();
}

Indices simplify(const Arrays& arrays, std::size_t faces) {
  Indices out(3 * arrays.triangles.size());
  out.resize(meshopt_simplify(out.data(), indices(arrays), out.size(), coordinates(arrays),
                              arrays.points.size(), sizeof(Arrays::Point), 3 * faces, kAnyError, 0, nullptr));
  return out;
}

Indices simplify_sloppy(const Arrays& arrays, std::size_t faces) {
  Indices out(3 * arrays.triangles.size());
  out.resize(meshopt_simplifySloppy(out.data(), indices(arrays), out.size(), coordinates(arrays),
                                    arrays.points.size(), sizeof(Arrays::Point), 3 * faces, kAnyError,
                                    nullptr));
  return out;
}

/// The outcome of meshoptimizer is a list of indices of the old points.
class MeshoptContender : public Contender {
 public:
  using Simplify = Indices (*)(const Arrays&, std::size_t);
  MeshoptContender(Simplify simplify, std::size_t faces) : simplify_(simplify), faces_(faces) {}

  void load(const Subject& subject) override { arrays_ = &subject.arrays; }
  void decimate(Phases&) override { out_ = simplify_(*arrays_, faces_); }

  /// Points that no triangle names are left out.
  Arrays unload() override {
    Arrays result;
    result.points.resize(arrays_->points.size());
    result.points.resize(meshopt_optimizeVertexFetch(result.points.data(), out_.data(), out_.size(),
                                                     arrays_->points.data(), arrays_->points.size(),
                                                     sizeof(Arrays::Point)));
    for (std::size_t i = 0; i + 2 < out_.size(); i += 3)
      result.triangles.push_back({out_[i], out_[i + 1], out_[i + 2]});
    return result;
  }

 protected:
  const Arrays* arrays_ = nullptr;
  Simplify simplify_;
  std::size_t faces_;
  Indices out_;
};

/// Looks for its request in the first run and keeps it for the others.
class SloppyContender : public MeshoptContender {
 public:
  SloppyContender(std::size_t faces, std::shared_ptr<std::optional<std::size_t>> request)
      : MeshoptContender(simplify_sloppy, faces), request_(std::move(request)) {}

  void load(const Subject& subject) override {
    MeshoptContender::load(subject);
    if (!*request_)
      *request_ = search_target(faces_, 1, subject.n_faces(), [&](std::size_t request) {
        return simplify_sloppy(subject.arrays, request).size() / 3;
      });
    faces_ = **request_;
  }

 private:
  std::shared_ptr<std::optional<std::size_t>> request_;
};

Entry entry(const char* method, const Target& target) {
  Entry e;
  e.method = method;
  e.target = target.name;
  e.target_faces = target.faces;
  e.in_place = true;
  return e;
}

}  // namespace

std::vector<Entry> meshopt_entries(const std::vector<Target>& targets) {
  std::vector<Entry> entries;
  for (const Target& target : targets) {
    entries.push_back(entry("meshopt_simplify", target));
    entries.back().make = [faces = target.faces] {
      return std::make_unique<MeshoptContender>(simplify, faces);
    };
  }
  return entries;
}

std::vector<Entry> meshopt_sloppy_entries(const std::vector<Target>& targets) {
  std::vector<Entry> entries;
  for (const Target& target : targets) {
    entries.push_back(entry("meshopt_simplifySloppy", target));
    const auto request = std::make_shared<std::optional<std::size_t>>();
    entries.back().make = [faces = target.faces, request] {
      return std::make_unique<SloppyContender>(faces, request);
    };
  }
  return entries;
}

}  // namespace whittle::speed
