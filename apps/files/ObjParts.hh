/// \file
/// What OBJ says of the faces that follow: usemtl, o, g and s.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "files/Parts.hh"

namespace whittle::files {

/// Follows these statements. Faces under the same four are one part, wherever they stand in the file.
class ObjParts {
 public:
  /// \param rest  gives what stands behind the keyword; called if the statement is one of these
  /// \return false if it is another one
  template <typename Rest>
  bool take(std::string_view keyword, Rest rest) {
    if (keyword == "mtllib") {
      if (const std::string_view name = rest(); !name.empty())
        parts_.libraries.push_back({std::string(name), {}});
      return true;
    }
    parts_.in_libraries = true;
    if (keyword == "usemtl")
      now_.material = material(std::string(rest()));
    else if (keyword == "o")
      now_.object = rest();
    else if (keyword == "g")
      now_.group = rest();
    else if (keyword == "s")
      now_.smoothing = rest();
    else
      return false;
    part_ = Part::none;
    return true;
  }

  /// The faces up to this number are of the current part.
  void add_faces(std::size_t count) {
    if (part_ == Part::none) {
      const auto fresh = static_cast<std::uint32_t>(parts_.list.size());
      part_ = numbers_.emplace(std::tuple(now_.material, now_.object, now_.group, now_.smoothing), fresh)
                  .first->second;
      if (part_ == fresh) parts_.list.push_back(now_);
    }
    parts_.of_face.resize(count, part_);
  }

  /// Without any face's part where the file says nothing of them.
  Parts take_parts() {
    const bool says_nothing =
        parts_.list.empty() ||
        (parts_.list.size() == 1 && numbers_.begin()->first == std::tuple(Part::none, "", "", ""));
    if (says_nothing) {
      parts_.of_face.clear();
      parts_.list.clear();
    }
    return std::move(parts_);
  }

 private:
  std::uint32_t material(const std::string& name) {
    if (name.empty()) return Part::none;
    const auto fresh = static_cast<std::uint32_t>(parts_.materials.size());
    const auto [place, is_new] = materials_.emplace(name, fresh);
    if (is_new) {
      parts_.materials.emplace_back();
      parts_.materials.back().name = name;
    }
    return place->second;
  }

  Parts parts_;
  Part now_;
  std::uint32_t part_ = Part::none;
  std::map<std::string, std::uint32_t> materials_;
  std::map<std::tuple<std::uint32_t, std::string, std::string, std::string>, std::uint32_t> numbers_;
};

}  // namespace whittle::files
