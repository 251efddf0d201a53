/// \file
/// The data of a finished glTF document, view by view, so that some can be packed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace whittle::files {

/// Whether a part of a mesh is of triangles, each with corners of its own.
bool shows_triangles(const nlohmann::json& part);

/// Takes the one buffer of a document apart, and puts it together again.
/// \pre all views lie in the first buffer, as GltfOutput leaves them
class GltfViews {
 public:
  using Json = nlohmann::json;

  struct View {
    std::string bytes;
    std::size_t stride = 0;  ///< between values, where the document says it
  };

  /// What an accessor is for.
  struct Use {
    std::size_t times = 0;  ///< that parts of meshes name it
    std::size_t mesh = 0;   ///< the first that does
    bool in_several_meshes = false, as_vertices = false, as_indices = false;
    bool of_triangles = true;  ///< no part that has it for its corners is of lines or points
    bool elsewhere = false;    ///< what is no part names it too: an animation, a skin, an extension
  };

  /// Throws what nlohmann::json throws where the document is damaged.
  GltfViews(Json& document, const std::string& buffer);

  Json& json() { return json_; }
  Json& accessor(std::size_t number) { return json_["accessors"].at(number); }
  const Use& use(std::size_t accessor) const { return uses_.at(accessor); }

  /// Whether an accessor has a view of its own, from its beginning, and only parts of meshes name it: it can be replaced.
  bool is_alone(std::size_t number) const;

  /// The same, of 32-bit floats.
  bool are_floats_alone(std::size_t number) const;

  /// Bytes of a value, without a gap behind it.
  std::size_t value_bytes(std::size_t number) const;

  /// Bytes from one value to the next.
  std::size_t stride(std::size_t number) const;

  /// \pre are_floats_alone()
  std::vector<float> floats(std::size_t number) const;

  /// \pre is_alone()
  std::vector<std::uint32_t> indices(std::size_t number) const;

  View& view_of(std::size_t accessor) { return views_[view_number(accessor)]; }
  const View& view_of(std::size_t accessor) const { return views_[view_number(accessor)]; }
  std::vector<View>& views() { return views_; }

  /// The accessors of a view, if only parts of meshes name it.
  const std::vector<std::size_t>& accessors_of(std::size_t view) const { return accessors_.at(view); }

  /// All views one behind the other again.
  std::string joined();

 private:
  std::size_t view_number(std::size_t accessor) const;
  void note_part(std::size_t mesh, const Json& part);
  void note_use(std::size_t mesh, const Json& number, bool Use::*as);

  Json& json_;
  std::vector<View> views_;
  std::vector<Use> uses_;
  std::vector<std::vector<std::size_t>> accessors_;  ///< of each view; none of one that is named elsewhere
};

}  // namespace whittle::files
