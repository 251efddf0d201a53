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

Json texture_change(const std::optional<files::ImageSize>& size, const files::MeshFile& in,
                    const Attribute& before, const recipe::Result& result, const Attribute& after) {
  attributes::TextureErrorOptions options;
  options.samples = kSamples;
  const Json image = count_in_texels_of(size, options);
  const auto error = attributes::texture_error(in.mesh, before, result.mesh, after, options);
  return {{"rms_texels", error.rms}, {"max_texels", error.max}, {"image", image}};
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

Json count_in_texels_of(const std::optional<files::ImageSize>& image,
                        attributes::TextureErrorOptions& options) {
  if (!image) return nullptr;
  options.texels = image->width;
  options.texels_high = image->height;
  return {{"width", image->width}, {"height", image->height}};
}

std::string texels_text(const Json& image) {
  const bool is_known = image.contains("width") && image.contains("height");
  return is_known ? "texels of " + image["width"].dump() + " x " + image["height"].dump() : "texels of 1,024";
}

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
  const Json::json_pointer image("/texture/image");
  add("texture", "rms_texels", "max_texels",
      texels_text(changes.contains(image) ? changes.at(image) : Json()));
  add("colours", "rms_255ths", "max_255ths", "of 255");
  add("normals", "rms_degrees", "max_degrees", "degrees");
  return out.empty() ? out : "  attributes off by, RMS and largest: " + out + "\n";
}

Json charts_json(const recipe::Result& result) {
  return {{"before", result.charts}, {"gone", result.charts_gone}};
}

Json pieces_json(const recipe::Recipe& recipe, const recipe::Result& result) {
  const std::size_t before = result.pieces_gone + result.attainable.pieces;
  return {{"rule", recipe.pieces.text()},
          {"before", before > 0 ? Json(before) : Json(nullptr)},
          {"gone", result.pieces_gone},
          {"faces_gone", result.faces_of_pieces_gone}};
}

std::string vanished_lines(const Json& charts, const Json& pieces) {
  const auto count = [](const Json& of, const char* name) -> std::size_t {
    return of.contains(name) && of[name].is_number_unsigned() ? of[name].get<std::size_t>() : 0;
  };
  std::string out;
  if (const std::size_t gone = count(charts, "gone"), before = count(charts, "before"); gone > 0)
    out += text::format("  %zu of %zu charts of the texture have vanished%s\n", gone, before,
                        2 * gone > before ? "; --drop texture leaves it out, and the shape is truer" : "");
  if (const std::size_t gone = count(pieces, "gone"); gone > 0)
    out += text::format("  %zu of %zu pieces have vanished, with %zu faces of the input\n", gone,
                        count(pieces, "before"), count(pieces, "faces_gone"));
  return out;
}

}  // namespace whittle::cli
