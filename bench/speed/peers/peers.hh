/// \file
/// Contenders from other libraries. CMake leaves out what is not installed.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "speed/Contender.hh"

namespace whittle::speed {

/// meshopt_simplify, bound by the count alone.
std::vector<Entry> meshopt_entries(const std::vector<Target>& targets);
/// meshopt_simplifySloppy, with the request that comes nearest to the target.
std::vector<Entry> meshopt_sloppy_entries(const std::vector<Target>& targets);
/// CGAL's edge collapse after Lindstrom and Turk, and after Garland and Heckbert.
std::vector<Entry> cgal_entries(const std::vector<Target>& targets);
/// How many pairs of faces intersect that share nothing, or more than they share. Faces that are not manifold
/// are left out.
std::size_t cgal_self_intersections(const Arrays& arrays);
/// vtkQuadricDecimation, vtkDecimatePro, vtkQuadricClustering.
std::vector<Entry> vtk_entries(const std::vector<Target>& targets);

/// Names and versions of the libraries that this program was built with.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace whittle::speed
