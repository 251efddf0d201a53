/// \file
/// The numbers of a glTF document.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tinygltf {
struct Accessor;
class Model;
}  // namespace tinygltf

namespace whittle::files {

/// Reads accessors. tinygltf hands over what the JSON says, so every index, offset, stride and count is
/// checked here.
class GltfData {
 public:
  /// \param model       its accessors and views
  /// \param buffers     the bytes of each buffer
  /// \param file_bytes  how long the file is. Accessors may share their bytes, and nodes their meshes, so
  ///                    what is read may take a multiple of it, but not any.
  GltfData(const tinygltf::Model& model, std::vector<std::string_view> buffers, std::size_t file_bytes)
      : model_(model),
        buffers_(std::move(buffers)),
        file_bytes_(file_bytes),
        budget_(most_bytes(file_bytes)) {}

  /// How much may be made of a file.
  static std::size_t most_bytes(std::size_t file_bytes) { return (std::size_t{16} << 20) + 64 * file_bytes; }

  /// Takes bytes from what may be taken. Even a part of nothing takes time, and many nodes may show it.
  /// \throw Fault  there are not so many left
  void charge(std::size_t count, std::size_t bytes_each);

  /// How many values the accessor has.
  std::size_t count(int accessor) const;

  /// How many components each of them has, and whether they are bytes that stand for 0..1.
  /// \{
  std::size_t components(int accessor) const;
  bool are_bytes(int accessor) const;
  /// \}

  /// Whether they are whole numbers that stand for themselves.
  bool are_whole(int accessor) const;

  /// The bytes of a view, as they are. \throw Fault  it is not there
  std::string_view view_bytes(std::size_t view) const;

  /// All components one after the other; normalized integers are 0..1 or -1..1.
  std::vector<float> floats(int accessor);

  /// \throw Fault  not integers, or more than one each
  std::vector<std::uint32_t> indices(int accessor);

 private:
  /// Values in a buffer, each a whole number of bytes behind the one before.
  struct Run {
    const char* begin = nullptr;  ///< null: they are all zero
    std::size_t stride = 0;
  };

  const tinygltf::Accessor& at(int accessor) const;
  void charge_values(const tinygltf::Accessor& accessor, std::size_t bytes_each);
  std::string_view view_data(long long view) const;
  Run run(long long view, std::size_t offset, std::size_t count, std::size_t value_bytes) const;
  void replace_sparse(const tinygltf::Accessor& accessor, std::vector<float>& values);

  const tinygltf::Model& model_;
  std::vector<std::string_view> buffers_;
  std::size_t file_bytes_;
  std::size_t budget_;  ///< bytes that may still be taken
};

}  // namespace whittle::files
