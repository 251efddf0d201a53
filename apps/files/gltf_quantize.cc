#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "files/bytes.hh"
#include "files/gltf_extensions.hh"
#include "files/gltf_pack.hh"
#include "files/gltf_transforms.hh"
#include "text/number.hh"

namespace whittle::files {
namespace {

using Json = nlohmann::json;
using Eigen::Vector3d;

constexpr int kQuantizedByte = 5120, kQuantizedShort = 5122, kQuantizedUnsignedShort = 5123;

/// Those of all parts of a mesh.
struct MeshAccessors {
  std::set<std::size_t> positions, shifts;  ///< the latter of morph targets
  std::set<std::size_t> directions;         ///< normals and tangents
  std::set<std::size_t> textures;
};

MeshAccessors accessors_in(const Json& mesh) {
  MeshAccessors out;
  for (const Json& part : mesh.at("primitives")) {
    for (const auto& [name, number] : part.at("attributes").items()) {
      const auto accessor = number.get<std::size_t>();
      if (name == "POSITION") out.positions.insert(accessor);
      if (name == "NORMAL" || name == "TANGENT") out.directions.insert(accessor);
      if (name.rfind("TEXCOORD_", 0) == 0) out.textures.insert(accessor);
    }
    if (!part.contains("targets")) continue;
    for (const Json& target : part["targets"])
      if (target.contains("POSITION")) out.shifts.insert(target["POSITION"].get<std::size_t>());
  }
  return out;
}

template <typename T>
T rounded_to(double value) {
  const double least = std::numeric_limits<T>::lowest(), most = std::numeric_limits<T>::max();
  return static_cast<T>(std::lround(std::clamp(value, least, most)));
}

class Quantizer {
 public:
  Quantizer(GltfViews& views, int bits, bool folds, WriteReport& report)
      : views_(views),
        nodes_(views.json()),
        bits_(bits),
        levels_(std::exp2(bits) - 1),
        folds_(folds),
        report_(report) {}

  void run() {
    if (!views_.json().contains("meshes")) return;
    for (std::size_t mesh = 0; mesh < views_.json()["meshes"].size(); ++mesh) quantize_mesh(mesh);
    if (!changed_) return;
    use_gltf_extension(views_.json(), "KHR_mesh_quantization", true);
    note();
  }

 private:
  void quantize_mesh(std::size_t mesh) {
    const MeshAccessors of = accessors_in(views_.json()["meshes"][mesh]);
    for (const std::size_t accessor : of.directions) quantize_directions(accessor);
    for (const std::size_t accessor : of.textures) quantize_texture(accessor);
    const char* against = quantize_positions(mesh, of);
    if (against != nullptr)
      reduce(report_, std::string("positions of a mesh that ") + against + " stay 32-bit floats");
  }

  bool can_replace(std::size_t accessor) {
    return done_.count(accessor) == 0 && views_.are_floats_alone(accessor);
  }

  void replace(std::size_t accessor, int type, bool normalized, std::string bytes, std::size_t stride) {
    views_.view_of(accessor) = {std::move(bytes), stride};
    Json& json = views_.accessor(accessor);
    json["componentType"] = type;
    json.erase("normalized");
    if (normalized) json["normalized"] = true;
    for (const char* key : {"min", "max"}) json.erase(key);
    done_.insert(accessor);
    changed_ = true;
  }

  void quantize_directions(std::size_t accessor) {
    if (!can_replace(accessor)) return;
    const std::vector<float> values = views_.floats(accessor);
    const std::size_t width = views_.value_bytes(accessor) / sizeof(float);
    if (width < 3) return;
    std::string bytes;
    for (std::size_t i = 0; i < values.size(); i += width) {
      Vector3d was, is;
      for (std::size_t k = 0; k < 4; ++k) {
        const double value = k < width ? static_cast<double>(values[i + k]) : 0;
        const auto narrow = rounded_to<std::int8_t>(std::clamp(127 * value, -127.0, 127.0));
        append_little(bytes, narrow);
        if (k == 3) continue;
        was[static_cast<int>(k)] = value;
        is[static_cast<int>(k)] = narrow;
      }
      const double turn = std::atan2(was.cross(is).norm(), was.dot(is));
      if (was.norm() > 0) turned_ = std::max(turned_, turn * 180 / static_cast<double>(EIGEN_PI));
    }
    replace(accessor, kQuantizedByte, true, std::move(bytes), 4);
  }

  void quantize_texture(std::size_t accessor) {
    if (!can_replace(accessor)) return;
    const std::vector<float> values = views_.floats(accessor);
    const bool fits =
        std::all_of(values.begin(), values.end(), [](float value) { return value >= 0 && value <= 1; });
    if (!fits) return reduce(report_, "texture coordinates beyond 0..1 stay 32-bit floats");
    constexpr double steps = 65535;
    std::string bytes;
    for (const float value : values) {
      const auto narrow = rounded_to<std::uint16_t>(steps * static_cast<double>(value));
      append_little(bytes, narrow);
      texture_moved_ = std::max(texture_moved_, std::abs(narrow / steps - static_cast<double>(value)));
    }
    replace(accessor, kQuantizedUnsignedShort, true, std::move(bytes), 0);
  }

  /// \return what is against it; null: it is done
  const char* quantize_positions(std::size_t mesh, const MeshAccessors& of) {
    for (const auto* list : {&of.positions, &of.shifts})
      for (const std::size_t accessor : *list)
        if (!can_replace(accessor) || views_.use(accessor).in_several_meshes ||
            views_.value_bytes(accessor) != 3 * sizeof(float))
          return "shares its data";
    Eigen::AlignedBox3d box;
    for (const std::size_t accessor : of.positions)
      for_each_point(accessor, [&](const Vector3d& point) { box.extend(point); });
    double longest_shift = 0;
    for (const std::size_t accessor : of.shifts)
      for_each_point(accessor, [&](const Vector3d& shift) {
        longest_shift = std::max(longest_shift, shift.cwiseAbs().maxCoeff());
      });
    if (box.isEmpty()) return nullptr;
    // A shift takes as many steps in either direction as half of a coordinate's range has.
    const double extent = std::max(box.sizes().maxCoeff(), longest_shift * levels_ / 32767);
    const double step = extent > 0 ? extent / levels_ : 1;
    if (!std::isnormal(static_cast<float>(step)) || !box.sizes().allFinite())
      return "is too small or too large";
    if (const char* against = nodes_.move(mesh, box.min(), step, folds_)) return against;
    for (const std::size_t accessor : of.positions) write_points<std::uint16_t>(accessor, box.min(), step);
    for (const std::size_t accessor : of.shifts) write_points<std::int16_t>(accessor, Vector3d::Zero(), step);
    return nullptr;
  }

  template <typename Action>
  void for_each_point(std::size_t accessor, Action action) const {
    const std::vector<float> values = views_.floats(accessor);
    for (std::size_t i = 0; i + 2 < values.size(); i += 3)
      action(Vector3d(static_cast<double>(values[i]), static_cast<double>(values[i + 1]),
                      static_cast<double>(values[i + 2])));
  }

  /// \tparam T  unsigned for positions, signed for shifts
  template <typename T>
  void write_points(std::size_t accessor, const Vector3d& origin, double step) {
    std::string bytes;
    Eigen::Array<T, 3, 1> least = Eigen::Array<T, 3, 1>::Zero(), most = least;
    for_each_point(accessor, [&](const Vector3d& point) {
      Eigen::Array<T, 3, 1> narrow;
      for (int k = 0; k < 3; ++k) narrow[k] = rounded_to<T>((point[k] - origin[k]) / step);
      least = bytes.empty() ? narrow : Eigen::Array<T, 3, 1>(least.min(narrow));
      most = bytes.empty() ? narrow : Eigen::Array<T, 3, 1>(most.max(narrow));
      for (const T value : narrow) append_little(bytes, value);
      append_little(bytes, T{0});
      moved_ = std::max(moved_, (origin + step * narrow.matrix().template cast<double>() - point).norm());
    });
    constexpr bool is_unsigned = std::is_unsigned_v<T>;
    replace(accessor, is_unsigned ? kQuantizedUnsignedShort : kQuantizedShort, false, std::move(bytes), 8);
    for (int k = 0; k < 3; ++k) {
      views_.accessor(accessor)["min"].push_back(least[k]);
      views_.accessor(accessor)["max"].push_back(most[k]);
    }
  }

  void note() {
    const auto up_to = [](double amount) { return ", by up to " + text::significant(amount, 3); };
    if (moved_ > 0)
      reduce(report_, "positions rounded to " + std::to_string(bits_) + " bits" + up_to(moved_) +
                          (folds_ ? " units" : " units of their mesh"));
    if (turned_ > 0) reduce(report_, "normals or tangents rounded to 8 bits" + up_to(turned_) + " degrees");
    if (texture_moved_ > 0) reduce(report_, "texture coordinates rounded to 16 bits" + up_to(texture_moved_));
  }

  GltfViews& views_;
  MeshNodes nodes_;
  int bits_;
  double levels_;
  bool folds_;
  WriteReport& report_;
  std::set<std::size_t> done_;
  bool changed_ = false;
  double moved_ = 0, turned_ = 0, texture_moved_ = 0;  ///< the largest of each
};

}  // namespace

void quantize_gltf(GltfViews& views, int bits, bool folds, WriteReport& report) {
  Quantizer(views, bits, folds, report).run();
}

}  // namespace whittle::files
