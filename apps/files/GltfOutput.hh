/// \file
/// A glTF document with its data, under construction.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace whittle::files {

/// Adds data to a document. Numbers of accessors and views that the document has keep what they name; those that are
/// given free are taken first.
class GltfOutput {
 public:
  using Json = nlohmann::json;
  enum class Target { none = 0, vertices = 34962, indices = 34963 };

  /// \param document  whose views are all in the one buffer that this begins with
  GltfOutput(Json document, std::string buffer) : json_(std::move(document)), buffer_(std::move(buffer)) {}

  Json& json() { return json_; }

  /// Numbers whose accessors and views are of no use any more, ascending.
  void set_free(std::vector<std::size_t> accessors, std::vector<std::size_t> views);

  /// \return the number of the view of these bytes
  std::size_t add_view(std::string_view bytes, Target target = Target::none, std::size_t stride = 0);

  /// \name Each returns the number of an accessor
  /// \{
  /// \param bounds  whether the least and the largest of each component are said, as of positions
  std::size_t add_floats(const std::vector<float>& values, std::size_t components, bool bounds = false);
  /// Of unit length, as glTF wants them; what is so within the precision of a file keeps its bits.
  std::size_t add_normals(std::vector<float> values);
  /// Whole numbers 0..65535, in as many bytes as the largest takes, four components each.
  std::size_t add_joints(const std::vector<float>& values);
  /// Colours of bytes.
  std::size_t add_bytes(const std::vector<float>& values, std::size_t components);
  std::size_t add_indices(const std::vector<std::uint32_t>& indices, std::size_t vertices);
  /// \}

  /// Ends the document: nothing can be added any more. \return its data, which may be packed now
  std::string& finish();

  /// The document as a GLB; nothing can be added any more. \throw Fault  more than 4 GiB
  std::string glb();

  /// The document, which names the file of its data. \param data  set to what goes there
  std::string gltf(const std::string& uri, std::string& data);

 private:
  std::size_t add_accessor(std::size_t view, int component_type, std::size_t components, std::size_t count);
  std::size_t put(const char* list, std::vector<std::size_t>& free, Json object);
  Json json_;
  std::string buffer_;
  bool is_finished_ = false;
  std::vector<std::size_t> free_accessors_, free_views_;  // descending: the next one is the last
};

}  // namespace whittle::files
