#include "cli/changes.hh"

#include <algorithm>
#include <cmath>

#include "attributes/TextureError.hh"
#include "attributes/ValueError.hh"
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

Json change_of(const files::MeshFile& in, const Attribute& before, const recipe::Result& result,
               const Attribute& after) {
  if (before.kind == Kind::texture) {
    attributes::TextureErrorOptions options;
    options.samples = kSamples;
    const auto error = attributes::texture_error(in.mesh, before, result.mesh, after, options);
    return {{"rms_texels_of_1024", error.rms}, {"max_texels_of_1024", error.max}};
  }
  const auto error = attributes::value_error(in.mesh, before, result.mesh, after, kSamples);
  if (before.kind == Kind::colour) {
    const double scale = 255 / std::sqrt(static_cast<double>(before.components));
    return {{"rms_255ths", scale * error.rms}, {"max_255ths", scale * error.max}};
  }
  const auto degrees = [](double chord) { return 360 / detail::kPi * std::asin(std::min(1.0, chord / 2)); };
  return {{"rms_degrees", degrees(error.rms)}, {"max_degrees", degrees(error.max)}};
}

}  // namespace

Json attribute_changes(const files::MeshFile& in, const recipe::Result& result) {
  Json changes;
  for (const auto& [kind, name] : {std::pair(Kind::texture, "texture"), std::pair(Kind::colour, "colours"),
                                   std::pair(Kind::normal, "normals")}) {
    const Attribute *before = first_of(in.attributes, kind), *after = first_of(result.attributes, kind);
    if (!before || !after) continue;
    try {
      changes[name] = change_of(in, *before, result, *after);
    } catch (const InvalidMesh&) {
      // No face has an area, in space or in the texture: there is nothing to measure.
    }
  }
  return changes;
}

std::string changes_line(const Json& changes) {
  std::string out;
  const auto add = [&](const char* name, const char* rms, const char* max, const char* unit) {
    if (!changes.contains(name)) return;
    out += text::format("%s%s %s and %s %s", out.empty() ? "" : ", ", name,
                        figure(changes[name][rms].get<double>()).c_str(),
                        figure(changes[name][max].get<double>()).c_str(), unit);
  };
  add("texture", "rms_texels_of_1024", "max_texels_of_1024", "texels of 1,024");
  add("colours", "rms_255ths", "max_255ths", "of 255");
  add("normals", "rms_degrees", "max_degrees", "degrees");
  return out.empty() ? out : "  attributes off by, RMS and largest: " + out + "\n";
}

}  // namespace whittle::cli
