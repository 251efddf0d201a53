/// \file
/// Another library's simplifier, as both benchmarks run it.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::peers {

/// Every library gets single precision, as mesh files hold it; CGAL computes in double.
using Arrays = IndexedMeshT<float>;

/// One simplification: `load`, `simplify`, `result`, in this order. Of a simplifier with `most` the last two may
/// be repeated with other requests.
class Run {
 public:
  Run() = default;
  virtual ~Run() = default;
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// Brings the mesh into the library's own form.
  /// \param mesh  has triangles, and stays where it is until `result` has returned.
  virtual void load(const Arrays& mesh) = 0;
  /// The call that is timed.
  /// \param request  the number of faces, or what Simplifier::most bounds.
  virtual void simplify(std::size_t request) = 0;
  /// The simplified mesh as arrays.
  virtual Arrays result() = 0;
};

/// A simplifier with what a benchmark has to know of it.
struct Simplifier {
  std::string name;  ///< "meshopt_simplify"
  std::unique_ptr<Run> (*start)();
  bool in_place = false;  ///< reads the arrays where they are
  bool slow = false;      ///< takes many times as long as the fastest
  bool countable = true;  ///< takes its memory from operator new, so that it can be counted
  /// Null where the request is the number of faces. Otherwise the request that comes nearest to a number of
  /// faces has to be searched for, between 1 and this function of the mesh's faces. A larger one leaves more.
  std::size_t (*most)(std::size_t faces) = nullptr;
};

}  // namespace whittle::peers
