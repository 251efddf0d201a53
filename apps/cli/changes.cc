#include "cli/changes.hh"

#include <algorithm>
#include <cmath>
#include <optional>

#include "attributes/TextureError.hh"
#include "attributes/ValueError.hh"
#include "files/image_size.hh"
#include "text/format.hh"
#include "whittle/surface/constants.hh"
#include "whittle/surface/errors.hh"

namespace whittle::cli {
namespace {

using attributes::Attribute;
using attributes::Kind;

constexpr std::size_t kSamples = 20000;

const Attribute* first_of(const attributes::Attributes& attributes, Kind kind) {
  const auto found =
      std::find_if(attributes.begin(), attributes.end(), [&](const auto& a) { return a.kind == kind; });
  return found == attributes.end() ? nullptr : &*found;
}

/// In texels of the image where it is known, else of 1,024 by 1,024.
Json texture_change(const std::optional<files::ImageSize>& image, const files::MeshFile& in,
                    const Attribute& before, const recipe::Result& result, const Attribute& after) {
  attributes::TextureErrorOptions options;
  options.samples = kSamples;
  if (image) {
    options.texels = image->width;
    options.texels_high = image->height;
  }
  const auto error = attributes::texture_error(in.mesh, before, result.mesh, after, options);
  return {{"rms_texels", error.rms},
          {"max_texels", error.max},
          {"image", image ? Json({{"width", image->width}, {"height", image->height}}) : Json(nullptr)}};
}

Json change_of(const std::optional<files::ImageSize>& image, const files::MeshFile& in,
               const Attribute& before, const recipe::Result& result, const Attribute& after) {
  if (before.kind == Kind::texture) return texture_change(image, in, before, result, after);
  const auto error = attributes::value_error(in.mesh, before, result.mesh, after, kSamples);
  if (before.kind == Kind::colour) {
    const double scale = 255 / std::sqrt(static_cast<double>(before.components));
    return {{"rms_255ths", scale * error.rms}, {"max_255ths", scale * error.max}};
  }
  const auto degrees = [](double chord) { return 360 / detail::kPi * std::asin(std::min(1.0, chord / 2)); };
  return {{"rms_degrees", degrees(error.rms)}, {"max_degrees", degrees(error.max)}};
}

}  // namespace

Json attribute_changes(const std::optional<files::ImageSize>& image, const files::MeshFile& in,
                       const recipe::Result& result) {
  Json changes;
  for (const auto& [kind, name] : {std::pair(Kind::texture, "texture"), std::pair(Kind::colour, "colours"),
                                   std::pair(Kind::normal, "normals")}) {
    const Attribute *before = first_of(in.attributes, kind), *after = first_of(result.attributes, kind);
    if (!before || !after) continue;
    try {
      changes[name] = change_of(image, in, *before, result, *after);
    } catch (const InvalidMesh&) {
      // No face has an area, in space or in the texture: there is nothing to measure.
    }
  }
  return changes;
}

std::string changes_line(const Json& changes) {
  std::string out;
  const auto add = [&](const std::string& of, const char* rms, const char* max, const std::string& unit) {
    const auto number = [&](const char* name) {
      const Json::json_pointer place("/" + of + "/" + name);
      const bool is_there = changes.contains(place) && changes.at(place).is_number();
      return is_there ? std::optional(changes.at(place).get<double>()) : std::nullopt;
    };
    if (number(rms) && number(max))
      out += text::format("%s%s %s and %s %s", out.empty() ? "" : ", ", of.c_str(),
                          figure(*number(rms)).c_str(), figure(*number(max)).c_str(), unit.c_str());
  };
  const Json::json_pointer image("/texture/image/width"), height("/texture/image/height");
  const bool is_known = changes.contains(image) && changes.contains(height);
  add("texture", "rms_texels", "max_texels",
      is_known ? "texels of " + changes.at(image).dump() + " x " + changes.at(height).dump()
               : "texels of 1,024");
  add("colours", "rms_255ths", "max_255ths", "of 255");
  add("normals", "rms_degrees", "max_degrees", "degrees");
  return out.empty() ? out : "  attributes off by, RMS and largest: " + out + "\n";
}

}  // namespace whittle::cli
