#include <memory>
#include <optional>
#include <utility>

#include "speed/TargetSearch.hh"
#include "speed/contenders/contenders.hh"

namespace whittle::speed {
namespace {

/// A simplifier's request: searched for in the first run, kept for the others.
using Request = std::shared_ptr<std::optional<std::size_t>>;

std::size_t best_request(const peers::Simplifier& simplifier, const Arrays& arrays, std::size_t wanted) {
  const auto run = simplifier.start();
  run->load(arrays);
  return search_target(wanted, 1, simplifier.most(arrays.triangles.size()), [&](std::size_t request) {
    run->simplify(request);
    return run->result().triangles.size();
  });
}

class PeerContender : public Contender {
 public:
  PeerContender(const peers::Simplifier& simplifier, std::size_t faces, Request request)
      : simplifier_(simplifier), run_(simplifier.start()), faces_(faces), request_(std::move(request)) {}

  void load(const Subject& subject) override {
    if (!*request_) *request_ = simplifier_.most ? best_request(simplifier_, subject.arrays, faces_) : faces_;
    run_->load(subject.arrays);
  }
  void decimate(Phases&) override { run_->simplify(**request_); }
  Arrays unload() override { return run_->result(); }

 private:
  peers::Simplifier simplifier_;
  std::unique_ptr<peers::Run> run_;
  std::size_t faces_;
  Request request_;
};

}  // namespace

std::vector<Entry> peer_entries(const std::vector<peers::Simplifier>& simplifiers,
                                const std::vector<Target>& targets) {
  std::vector<Entry> entries;
  for (const Target& target : targets) {
    for (const peers::Simplifier& simplifier : simplifiers) {
      Entry& e = entries.emplace_back();
      e.method = simplifier.name;
      e.target = target.name;
      e.target_faces = target.faces;
      e.heavy = simplifier.slow;
      e.in_place = simplifier.in_place;
      e.countable = simplifier.countable;
      const auto request = std::make_shared<std::optional<std::size_t>>();
      e.make = [simplifier, faces = target.faces, request] {
        return std::make_unique<PeerContender>(simplifier, faces, request);
      };
    }
  }
  return entries;
}

}  // namespace whittle::speed
