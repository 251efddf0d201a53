/// \file
/// OBJ's three lists, of vertices, texture coordinates and normals, and how faces name their entries.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "files/Fault.hh"
#include "files/MeshBuilder.hh"

namespace whittle::files {

/// The indices of one list. They count from 1, or back from the last entry read; and a face may name what
/// comes later in the file, so what is wrong shows at the end only.
class ObjIndices {
 public:
  /// \param things  for messages: "vertex"
  explicit ObjIndices(std::string things) : things_(std::move(things)) {}

  /// \param index  as in the file
  /// \param count  entries of the list so far
  /// \param line   where it stands
  /// \return from 0; at least as large as the whole list where it is wrong
  std::uint32_t resolve(std::int64_t index, std::size_t count, std::size_t line) {
    const auto entries = static_cast<std::int64_t>(count);
    const bool never_there = index == 0 || index < -entries || index > std::int64_t{no_vertex};
    if (never_there && !wrong_.line) wrong_ = {index, count, line};
    if (never_there) return no_vertex;
    if (index < 0) return static_cast<std::uint32_t>(entries + index);
    if (index > entries && index > furthest_.index) furthest_ = {index, count, line};
    return static_cast<std::uint32_t>(index - 1);
  }

  /// To be called at the end, with the whole list's size; sooner for what need not wait.
  /// \param line  set to where the wrong index stands
  void check(std::size_t count, std::size_t& line) const {
    if (wrong_.line) {
      line = wrong_.line;
      if (wrong_.index == 0) throw Fault(things_ + " index 0: OBJ counts from 1");
      throw_index_out_of_range(things_, wrong_.index, wrong_.count);
    }
    if (furthest_.index <= static_cast<std::int64_t>(count)) return;
    line = furthest_.line;
    throw_index_out_of_range(things_, furthest_.index, count);
  }

 private:
  struct Index {
    std::int64_t index = 0;
    std::size_t count = 0;
    std::size_t line = 0;
  };

  std::string things_;
  Index wrong_;     ///< the first that no later line can make right
  Index furthest_;  ///< the largest of an entry that was not there yet
};

}  // namespace whittle::files
