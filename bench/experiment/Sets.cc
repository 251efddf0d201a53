#include "experiment/Sets.hh"

#include <algorithm>
#include <initializer_list>

namespace whittle::bench {
namespace {

SetDefinition original() {
  return {"original", "Original", "", "", "", "", Role::paper};
}

/// A set of Paper 1 or a point of a curve: "IVDD", "0.0011" and "ivdd:distance=0.0011".
SetDefinition curve_point(const std::string& algorithm, const std::string& lower, const std::string& key,
                          const std::string& value, const std::string& unit) {
  return {lower + "-" + value,
          algorithm + " " + key + " " + value + unit,
          algorithm,
          value + unit,
          lower + ":" + key + "=" + value,
          "",
          Role::curve};
}

void add_curves(std::vector<SetDefinition>& sets) {
  for (const char* passes : {"1", "2", "3"}) {
    const std::string n = passes;
    sets.push_back({n == "1" ? "vt" : "vt-passes-" + n, "VT, passes " + n, "VT", n + "×",
                    n == "1" ? "vt" : "vt:passes=" + n, "", Role::curve});
  }
  for (const char* angle : {"5", "10", "20", "30", "150"})
    sets.push_back(curve_point("FAD", "fad", "angle", angle, "°"));
  for (const char* d : {"0.0009", "0.0011", "0.0013", "0.0016", "0.002"})
    sets.push_back(curve_point("IVDD", "ivdd", "distance", d, ""));
  for (const char* r : {"0.001", "0.0012", "0.0014", "0.0017", "0.002"})
    sets.push_back(curve_point("SS", "ss", "radius", r, ""));
  for (const char* d : {"0.0009", "0.0011", "0.0013", "0.0016", "0.002"})
    sets.push_back(curve_point("VTD", "vtd", "distance", d, ""));
  for (const char* r : {"0.001", "0.0012", "0.0014", "0.0017", "0.002"}) {
    const std::string radius = r;
    sets.push_back({"fass-" + radius + "-30", "FASS radius " + radius + ", angle 30°", "FASS", radius,
                    "fass:radius=" + radius + ",angle=30", "", Role::curve});
  }
}

/// The same ranked by the error that a merge adds and placed by quadrics, where that can be.
void add_error_curves(std::vector<SetDefinition>& sets) {
  const std::string settings = "placement=quadric,order=error";
  const auto add = [&](const std::string& algorithm, const std::string& name, const std::string& parameter,
                       const std::string& recipe) {
    sets.push_back({name + "-by-error", algorithm + " " + parameter + ", by error", algorithm + " by error",
                    parameter, recipe + "," + settings, "", Role::curve});
  };
  for (const std::string passes : {"1", "2", "3"})
    add("VT", "vt-passes-" + passes, passes + "×", "vt:passes=" + passes);
  for (const std::string d : {"0.0009", "0.0013", "0.002"}) add("IVDD", "ivdd-" + d, d, "ivdd:distance=" + d);
  for (const std::string r : {"0.001", "0.0014", "0.002"}) {
    add("SS", "ss-" + r, r, "ss:radius=" + r);
    add("FASS", "fass-" + r + "-30", r, "fass:radius=" + r + ",angle=30");
  }
}

/// The papers' algorithms, refitted.
void add_refitted_curves(std::vector<SetDefinition>& sets) {
  const auto add = [&](const std::string& algorithm, const std::string& name, const std::string& parameter,
                       const std::string& recipe) {
    sets.push_back({name + "-refitted", algorithm + " " + parameter + ", refitted", algorithm + " refitted",
                    parameter, recipe + SetDefinition::kRefitSuffix, "", Role::curve});
  };
  for (const std::string passes : {"1", "3"})
    add("VT", "vt-passes-" + passes, passes + "×", "vt:passes=" + passes);
  for (const std::string d : {"0.0009", "0.002"}) {
    add("IVDD", "ivdd-" + d, d, "ivdd:distance=" + d);
    add("VTD", "vtd-" + d, d, "vtd:distance=" + d);
  }
  for (const std::string r : {"0.001", "0.002"}) {
    add("SS", "ss-" + r, r, "ss:radius=" + r);
    add("FASS", "fass-" + r + "-30", r, "fass:radius=" + r + ",angle=30");
  }
}

void add_literal(std::vector<SetDefinition>& sets) {
  const auto add = [&](const std::string& base, const std::string& algorithm, const std::string& parameter,
                       const std::string& words, const std::string& recipe) {
    sets.push_back({base + "-literal", algorithm + " " + parameter + (parameter.empty() ? "" : ", ") + words,
                    algorithm, parameter, recipe, base, Role::literal});
  };
  add("vt", "VT", "", "true circumcentre, no guard", "vt:placement=circumcenter,guard=-1");
  for (const std::string d : {"0.0011", "0.0013"})
    add("ivdd-" + d, "IVDD", d, "true circumcentre, no guard",
        "ivdd:distance=" + d + ",placement=circumcenter,guard=-1");
  for (const std::string r : {"0.0012", "0.0014"})
    add("ss-" + r, "SS", r, "until nothing changes, no guard", "ss:radius=" + r + ",passes=1000,guard=-1");
  for (const std::string d : {"0.0011", "0.0013"})
    add("vtd-" + d, "VTD", d, "longer edge, true circumcentre, no guard",
        "vtd:distance=" + d + ",fold=literal,placement=circumcenter,guard=-1");
}

/// One set of each algorithm, for the comparisons that would be too many otherwise.
constexpr std::initializer_list<const char*> kOneEach = {"vt",        "fad-30",     "ivdd-0.0013",
                                                         "ss-0.0014", "vtd-0.0013", "fass-0.0014-30"};

}  // namespace

const std::vector<SetDefinition>& paper1_sets() {
  static const std::vector<SetDefinition> sets = {
      original(),
      {"vt", "VT", "VT", "", "vt", "", Role::paper},
      {"fad-30", "FAD (Included angle <= 30°)", "FAD", "30°", "fad:angle=30", "", Role::paper},
      {"fad-150", "FAD (Included angle <= 150°)", "FAD", "150°", "fad:angle=150", "", Role::paper},
      {"ivdd-0.0011", "IVDD (Distance = 0.0011)", "IVDD", ".0011", "ivdd:distance=0.0011", "", Role::paper},
      {"ivdd-0.0013", "IVDD (Distance = 0.0013)", "IVDD", ".0013", "ivdd:distance=0.0013", "", Role::paper},
      {"ss-0.0012", "SS (Radius = 0.0012)", "SS", ".0012", "ss:radius=0.0012", "", Role::paper},
      {"ss-0.0014", "SS (Radius = 0.0014)", "SS", ".0014", "ss:radius=0.0014", "", Role::paper},
      {"vtd-0.0011", "VTD (Distance = 0.0011)", "VTD", ".0011", "vtd:distance=0.0011", "", Role::paper},
      {"vtd-0.0013", "VTD (Distance = 0.0013)", "VTD", ".0013", "vtd:distance=0.0013", "", Role::paper},
      {"fass-0.0012-30", "FASS (Radius = 0.0012 & angle < 30°)", "FASS", ".0012 30°",
       "fass:radius=0.0012,angle=30", "", Role::paper},
      {"fass-0.0012-150", "FASS (Radius = 0.0012 & angle < 150°)", "FASS", ".0012 150°",
       "fass:radius=0.0012,angle=150", "", Role::paper},
      {"fass-0.0014-30", "FASS (Radius = 0.0014 & angle < 30°)", "FASS", ".0014 30°",
       "fass:radius=0.0014,angle=30", "", Role::paper},
      {"fass-0.0014-150", "FASS (Radius = 0.0014 & angle < 150°)", "FASS", ".0014 150°",
       "fass:radius=0.0014,angle=150", "", Role::paper},
  };
  return sets;
}

const std::vector<SetDefinition>& paper2_sets() {
  static const std::vector<SetDefinition> sets = [] {
    std::vector<SetDefinition> all = {original()};
    for (const std::string angle : {"30", "60", "120", "150"}) {
      const std::string name = "included-" + angle, degrees = angle + "°";
      all.push_back({name, "> " + degrees, "FAD", "> " + degrees, "fad:included=" + angle, "", Role::paper});
      all.push_back({name + "-literal", "> " + degrees + ", by the words", "FAD", "> " + degrees,
                     "fad:included=" + angle + ",pairs=all,lock=strict,apex=lexicographic", name,
                     Role::literal});
    }
    return all;
  }();
  return sets;
}

std::vector<SetDefinition> beyond_sets(const std::vector<PeerName>& peers) {
  std::vector<SetDefinition> sets = {original()};
  add_curves(sets);
  add_error_curves(sets);
  add_refitted_curves(sets);
  for (const PeerName& peer : peers)
    for (const std::string base : kOneEach)
      sets.push_back(
          {peer.name + "-as-" + base, peer.label, peer.label, "", "peer:" + peer.name, base, Role::peer});
  add_literal(sets);
  sets.push_back({"original-cached", "Original", "", "", "", "original", Role::cache});
  for (const std::string base : kOneEach)
    sets.push_back({base + "-cached", base, "", "", "", base, Role::cache});
  return sets;
}

std::vector<SetDefinition> choose_sets(const std::vector<std::string>& names) {
  const auto& all = paper1_sets();
  const auto is_unknown = [&](const std::string& name) {
    return name != "all" &&
           std::none_of(all.begin(), all.end(), [&](const auto& set) { return set.name == name; });
  };
  const auto unknown = std::find_if(names.begin(), names.end(), is_unknown);
  if (unknown != names.end()) {
    std::string known = "all";
    for (const auto& set : all) known.append(", ").append(set.name);
    throw std::invalid_argument("there is no set \"" + *unknown + "\"; there are " + known);
  }
  if (names.empty() || std::count(names.begin(), names.end(), "all") > 0) return all;

  std::vector<SetDefinition> chosen;
  for (const auto& set : all) {
    if (set.original() || std::count(names.begin(), names.end(), set.name) > 0) chosen.push_back(set);
  }
  return chosen;
}

}  // namespace whittle::bench
