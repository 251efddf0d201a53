#include "experiment/Protocol.hh"

namespace whittle::bench {

Timing& Protocol::timing(const std::string& experiment) {
  return experiment == "paper1" ? paper1 : experiment == "paper2" ? paper2 : beyond;
}

Protocol paper_protocol() {
  Protocol protocol;
  protocol.name = "paper";
  protocol.paper1 = {100, 1100, 10};
  protocol.paper2 = {100, 200, 10};
  protocol.beyond = {10, 60, 5};
  return protocol;
}

Protocol quick_protocol() {
  Protocol protocol;
  protocol.name = "quick";
  protocol.settings.samples = 50000;
  protocol.paper1 = {10, 60, 5};
  protocol.paper2 = {100, 200, 5};
  protocol.beyond = {5, 25, 3};
  return protocol;
}

}  // namespace whittle::bench
