#include "speed/lineup.hh"

#include <algorithm>
#include <iterator>

#include "speed/contenders/contenders.hh"

namespace whittle::speed {
namespace {

void append(std::vector<Entry>& entries, std::vector<Entry> more) {
  std::move(more.begin(), more.end(), std::back_inserter(entries));
}

std::vector<Entry> everybody(Suite suite, const Subject& subject) {
  std::vector<Target> like_planned;
  for (const Target& planned : planned_faces(subject))
    like_planned.push_back({"as " + planned.name, planned.faces});
  const std::vector<Target> shares = {{"50 %", subject.n_faces() / 2}, {"10 %", subject.n_faces() / 10}};

  std::vector<Entry> entries = conversion_entries();
  append(entries, bulk_entries(subject));
  append(entries, sweep_entries(subject));
  append(entries, peer_entries({peers::meshopt()}, like_planned));
  if (suite == Suite::figures) {
    append(entries, mq_entries(shares));
    append(entries, planned_decimater_entries(subject));
    append(entries, peer_entries({peers::meshopt_sloppy()}, like_planned));
    append(entries, quadric_entries(shares));
    append(entries, peer_entries({peers::meshopt()}, shares));
    append(entries, peer_entries({peers::meshopt_sloppy()}, shares));
    append(entries, compaction_entries(subject));
#ifdef WHITTLE_WITH_CGAL
    append(entries, peer_entries({peers::cgal_lindstrom_turk(), peers::cgal_garland_heckbert()}, shares));
#endif
#ifdef WHITTLE_WITH_VTK
    append(entries, peer_entries({peers::vtk_quadric_decimation(), peers::vtk_decimate_pro(),
                                  peers::vtk_quadric_clustering()},
                                 shares));
#endif
  }
  return entries;
}

/// The most accurate simplifiers, down to shares of the faces.
std::vector<Entry> truthful(const Subject& subject) {
  std::vector<Target> shares;
  for (const auto& [name, part] :
       {std::pair("50 %", 0.5), {"25 %", 0.25}, {"10 %", 0.1}, {"2 %", 0.02}, {"1 %", 0.01}})
    shares.push_back({name, static_cast<std::size_t>(part * static_cast<double>(subject.n_faces()))});
  std::vector<Entry> entries = mq_entries(shares);
  append(entries, mq_entries(shares, 1));
  append(entries, mq_entries(shares, 0, false));
  append(entries, mq_entries(shares, 1, false));
  append(entries, sweep_mq_entries(shares));
  append(entries, peer_entries({peers::meshopt()}, shares));
#ifdef WHITTLE_WITH_CGAL
  append(entries, peer_entries({peers::cgal_lindstrom_turk()}, shares));
#endif
  return entries;
}

}  // namespace

std::string to_string(Suite suite) {
  return suite == Suite::figures ? "figures" : suite == Suite::growth ? "growth" : "truth";
}

std::vector<Entry> lineup(Suite suite, const Subject& subject, const std::optional<std::regex>& only) {
  std::vector<Entry> entries = suite == Suite::truth ? truthful(subject) : everybody(suite, subject);
  if (only) {
    const auto left_out = [&](const Entry& entry) { return !std::regex_search(entry.name(), *only); };
    entries.erase(std::remove_if(entries.begin(), entries.end(), left_out), entries.end());
  }
  return entries;
}

}  // namespace whittle::speed
