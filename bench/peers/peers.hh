/// \file
/// Other libraries' simplifiers: one adapter a library, for both benchmarks. CGAL's are there with
/// WHITTLE_WITH_CGAL, VTK's with WHITTLE_WITH_VTK, which CMake sets where it has found them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "peers/Simplifier.hh"

namespace whittle::peers {

/// meshopt_simplify without options; only the number of faces bounds it, no error.
Simplifier meshopt();
/// meshopt_simplifySloppy, which clusters vertices; no error bounds it.
Simplifier meshopt_sloppy();

/// CGAL's edge collapse with its default policies, those of Lindstrom and Turk.
Simplifier cgal_lindstrom_turk();
/// CGAL's edge collapse by plane quadrics, with a bound on the change of normals, as in CGAL's own example.
Simplifier cgal_garland_heckbert();
/// How many pairs of faces intersect that share nothing, or more than they share. Faces that are not manifold
/// are left out. Counted by CGAL.
std::size_t cgal_self_intersections(const Arrays& mesh);

Simplifier vtk_quadric_decimation();
Simplifier vtk_decimate_pro();  ///< keeps the topology
Simplifier
vtk_quadric_clustering();  ///< the request: cells along the longest side of the box, all about cubes

/// Names and versions of the libraries that this program was built with.
std::vector<std::pair<std::string, std::string>> versions();

}  // namespace whittle::peers
