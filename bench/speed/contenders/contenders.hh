/// \file
/// Whittle's own contenders, OpenMesh's and other libraries'.
#pragma once

#include <vector>

#include "peers/peers.hh"
#include "speed/Contender.hh"

namespace whittle::speed {

/// For each planned module its name and how many faces it leaves.
std::vector<Target> planned_faces(const Subject& subject);

/// Thresholds of the planned modules, in mean edges; with Stanford's bunny, whose mean edge is 0.00147, they
/// are about the papers' 0.0011 for a distance and 0.0012 for a radius. FAD goes up to 30 degrees.
inline constexpr double kDistanceInEdges = 0.75, kRadiusInEdges = 0.82;

/// Planned modules on arrays.
std::vector<Entry> bulk_entries(const Subject& subject);
/// mq on arrays.
/// \param threads  0: as many as there are; else the name says how many
/// \param refit    whether the result is refitted, as it is by default; else the name says that it is not
std::vector<Entry> mq_entries(const std::vector<Target>& targets, std::size_t threads = 0, bool refit = true);
/// Planned modules in the sweep.
std::vector<Entry> sweep_entries(const Subject& subject);
/// mq as a module in the sweep, to a number of faces.
std::vector<Entry> sweep_mq_entries(const std::vector<Target>& targets);
/// Planned modules in LazyDecimaterT and in OpenMesh's DecimaterT.
std::vector<Entry> planned_decimater_entries(const Subject& subject);
/// ModQuadricT, alone and with ModNormalFlippingT, in LazyDecimaterT and in OpenMesh's decimaters.
std::vector<Entry> quadric_entries(const std::vector<Target>& targets);
/// compact() and garbage_collection() after the same decimation.
std::vector<Entry> compaction_entries(const Subject& subject);
/// What surrounds a decimation: the arrays copied once, and conversions from and to OpenMesh.
std::vector<Entry> conversion_entries();

/// Other libraries' simplifiers, each to each target. Of those with another request than a number of faces, the
/// one that comes nearest is searched for in the first run.
std::vector<Entry> peer_entries(const std::vector<peers::Simplifier>& simplifiers,
                                const std::vector<Target>& targets);

}  // namespace whittle::speed
