/// \file
/// The images that PLY's comments name, of which MeshLab's faces have the numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "files/MeshFile.hh"

namespace whittle::files {

/// Each image becomes a material, and its faces a part.
class PlyTextures {
 public:
  explicit PlyTextures(std::size_t images) : images_(images) {}

  bool any() const { return images_ > 0; }

  /// For the faces up to the next add_faces(). What names no image makes them of no material.
  void set(std::int64_t number) {
    const bool is_there = number >= 0 && static_cast<std::uint64_t>(number) < images_;
    now_ = is_there ? static_cast<std::uint32_t>(number) : static_cast<std::uint32_t>(images_);
  }

  /// The faces up to this number are of the image that was set, or of the first one.
  void add_faces(std::size_t count) {
    if (any()) of_face_.resize(count, now_);
    now_ = 0;
  }

  /// Hands the parts over.
  /// \param path  of the PLY file, beside which the images are
  void finish(const std::vector<std::string>& names, const std::filesystem::path& path, MeshFile& file);

 private:
  std::size_t images_;
  std::uint32_t now_ = 0;
  std::vector<std::uint32_t> of_face_;
};

/// What a PLY file says of materials.
struct PlyImages {
  std::vector<std::string> names;  ///< of files
  std::vector<std::int32_t>
      of_face;  ///< numbers of names, -1: none; empty: there is one, which all faces have
};

/// Images that were within another file are written beside the PLY file, others are referred to or copied. What is lost of
/// the materials is noted.
PlyImages ply_images(const Parts& parts, const std::filesystem::path& path, bool copies, Encoded& out);

}  // namespace whittle::files
