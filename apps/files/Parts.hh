/// \file
/// Which faces of a mesh belong together, and what they are made of.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace whittle::files {

/// An image that a material names: a file, or bytes within the mesh's file.
struct Image {
  std::string name;            ///< what the mesh's file calls it; a file's name as it stands there
  std::filesystem::path path;  ///< where its file is; empty: it has none that may be read
  std::string bytes = {};      ///< of an image within the mesh's file
};

/// What the formats have in common of a material. A glTF scene and a material library that is referred to keep
/// theirs whole beside this.
struct Material {
  enum class Alpha { opaque, mask, blend };

  std::string name;
  std::array<double, 4> colour = {1, 1, 1, 1};  ///< base colour and opacity, 0..1; OBJ's Kd and d
  std::optional<std::size_t> image = {};        ///< of the base colour, among Parts::images; OBJ's map_Kd
  /// Where on the image a texture coordinate is: times the first, plus the second, v upwards. OBJ's -s and -o; of a scene,
  /// which keeps the transform itself, only how large the first is
  std::array<double, 2> texture_scale = {1, 1}, texture_offset = {0, 0};
  Alpha alpha = Alpha::opaque;  ///< what opacity means, as glTF has it
  double cutoff = 0.5;          ///< below which a mask is not seen

  bool is_texture_moved() const {
    return texture_scale != Material().texture_scale || texture_offset != Material().texture_offset;
  }
};

/// What a file says of the faces that follow: OBJ's usemtl, o, g and s.
struct Part {
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  std::uint32_t material = none;         ///< among Parts::materials
  std::string object, group, smoothing;  ///< as the file has them; empty: not said
};

/// A file of materials that an OBJ file names.
struct Library {
  std::string name;            ///< as it stands there
  std::filesystem::path path;  ///< where it is said to be; empty: the OBJ file came from standard input
};

/// The parts of a mesh, in the order in which the file begins them.
struct Parts {
  std::vector<Part> list;
  std::vector<std::uint32_t> of_face;  ///< for each face its part; empty: nothing is said of any
  std::vector<Material> materials;
  std::vector<Image> images;
  bool in_libraries = false;  ///< what the materials are is said in libraries, also where those are missing
  std::vector<Library> libraries;  ///< OBJ

  bool has_materials() const { return !materials.empty() || !libraries.empty(); }

  /// For each face a number: between faces of different ones there is a seam. Empty where all have the same.
  /// \param groups  whether each part counts, not only its material
  std::vector<std::uint32_t> areas(bool groups = false) const;

  /// Forgets the materials, but not which faces belong together.
  void drop_materials();
};

}  // namespace whittle::files
