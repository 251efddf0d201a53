#include "render/heat_colour.hh"

#include <algorithm>

namespace whittle::render {
namespace {

constexpr int kSteps = 4;
constexpr int kStops[kSteps + 1][3] = {  // in thousandths
    {267, 5, 329},
    {231, 322, 545},
    {129, 569, 549},
    {369, 788, 384},
    {993, 906, 144}};

std::string make_shader() {
  std::string stops;
  for (const auto& stop : kStops) {
    stops += stops.empty() ? "vec3(" : ", vec3(";
    for (int i = 0; i < 3; ++i) stops += std::to_string(stop[i]) + (i < 2 ? ".0, " : ".0) / 1000.0");
  }
  const std::string steps = std::to_string(kSteps), n = std::to_string(kSteps + 1);
  std::string text = "const vec3 heat_stops[" + n + "] = vec3[" + n + "](" + stops + ");\n";
  text += "vec3 heat_colour(float value) {\n";
  text += "  float along = " + steps + ".0 * clamp(value, 0.0, 1.0);\n";
  text += "  int stop = min(int(along), " + steps + " - 1);\n";
  text += "  return mix(heat_stops[stop], heat_stops[stop + 1], along - float(stop));\n}\n";
  return text;
}

/// Of the i-th stop, as red, green and blue.
Eigen::Vector3f colour(int i) {
  return Eigen::Vector3i(kStops[i]).cast<float>() / 1000;
}

}  // namespace

Eigen::Vector3f heat_colour(double value) {
  const double along = kSteps * std::clamp(value, 0.0, 1.0);
  const int stop = std::min(static_cast<int>(along), kSteps - 1);
  const auto part = static_cast<float>(along - stop);
  return (1 - part) * colour(stop) + part * colour(stop + 1);
}

const std::string& heat_colour_shader() {
  static const std::string shader = make_shader();
  return shader;
}

}  // namespace whittle::render
