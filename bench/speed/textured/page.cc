#include <array>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "speed/textured/suite.hh"
#include "text/format.hh"

namespace whittle::speed {
namespace {

std::string fixed(double value, int digits) {
  return text::format("%.*f", digits, value);
}

/// "0.59 / 4.2": of all samples together, and the largest.
std::string both(const Json& error) {
  return error.is_null()
             ? ""
             : fixed(error.at("rms").get<double>(), 2) + " / " + fixed(error.at("max").get<double>(), 1);
}

double rms(const Json& result) {
  return result.at("rms_ten_thousandths_of_diagonal").get<double>();
}

bool is_ours(const Json& result) {
  return result.at("contender") == "mq";
}

std::optional<double> shape_ratio(const Json& result) {
  if (!result.contains("rms_without_attributes")) return std::nullopt;
  const double plain = result.at("rms_without_attributes").get<double>();
  return plain > 0 ? std::optional(rms(result) / plain) : std::nullopt;
}

std::optional<double> time_ratio(const Json& result, const char* counts, const char* span) {
  if (!result.contains("seconds") || !result.at("seconds").contains(counts)) return std::nullopt;
  const Json& seconds = result.at("seconds");
  return seconds.at(counts).at(span).get<double>() / seconds.at("nothing").at(span).get<double>();
}

std::string times(std::optional<double> ratio) {
  return ratio ? fixed(*ratio, 2) : "";
}

void write_result(std::ostream& out, const Json& model, const Json& result) {
  out << "| " << model.at("name").get<std::string>() << " | " << result.at("percent") << " | "
      << result.at("contender").get<std::string>() << " | " << result.at("faces") << " | "
      << fixed(rms(result), 2) << " | "
      << (is_ours(result) ? fixed(result.at("rms_without_attributes").get<double>(), 2) : "") << " | "
      << times(shape_ratio(result)) << " | " << both(result.at("texture_texels_of_1024"))
      << both(result.at("colours_255ths")) << " | ";
  const Json& texture = result.at("texture_texels_of_1024");
  if (!texture.is_null()) out << texture.at("charts_left") << " of " << texture.at("charts");
  out << " | " << (result.at("topology_kept").get<bool>() ? "kept" : "**changed**") << " | "
      << (result.at("psnr_db").is_null() ? "" : fixed(result.at("psnr_db").get<double>(), 1)) << " | "
      << (is_ours(result) ? fixed(1000 * result.at("seconds").at("nothing").at("decimation").get<double>(), 1)
                          : "")
      << " | " << times(time_ratio(result, "seams", "decimation")) << " | "
      << times(time_ratio(result, "values", "decimation")) << " | "
      << times(time_ratio(result, "values", "whole")) << " |\n";
}

void write_half(std::ostream& out, const Json& suite, const std::string& half) {
  bool begun = false;
  for (const Json& model : suite.at("models")) {
    if (model.at("half") != half) continue;
    if (!begun)
      out << "### Models: " << half << "\n\n"
          << "| model | % | by | faces | RMS | without | ratio | texture or colours | charts | topology | "
             "PSNR | "
             "ms without | seams × | values × | whole × "
             "|\n|---|--:|---|--:|--:|--:|--:|--:|--:|---|--:|--:|--:|--:|--:|\n";
    begun = true;
    for (const Json& result : model.at("results")) write_result(out, model, result);
  }
  if (begun) out << "\n";
}

/// A figure that is to stay below a limit, over all models: how often it does, and where it does not.
class Limit {
 public:
  Limit(std::string what, double most) : what_(std::move(what)), most_(most) {}

  void add(const std::string& where, double value) {
    ++n_;
    if (value <= most_) return;
    misses_ += (misses_.empty() ? "" : ", ") + where + " " + fixed(value, 2);
    ++n_missed_;
  }
  void write(std::ostream& out) const {
    if (n_ > 0)
      out << "| " << what_ << " | ≤ " << most_ << " | " << n_ - n_missed_ << " of " << n_ << " | " << misses_
          << " |\n";
  }

 private:
  std::string what_, misses_;
  double most_;
  std::size_t n_ = 0, n_missed_ = 0;
};

double texture_rms(const Json& result) {
  const Json& texture = result.at("texture_texels_of_1024");
  return texture.is_null() ? 0 : texture.at("rms").get<double>();
}

/// Within a hundredth and two faces.
bool reaches(const Json& model, const Json& result) {
  const double wanted = model.at("faces").get<double>() * result.at("percent").get<double>() / 100;
  return result.at("faces").get<double>() <= 1.01 * wanted + 2;
}

void write_goals(std::ostream& out, const Json& suite) {
  Limit reached("faces at the target (0: yes)", 0), shape("RMS against no texture, at 50, 25, 10 %", 1.15),
      seams("time with seams against none", 1.3), values("time with values against none", 1.8),
      peers("texture RMS against a peer's, where both reach the target", 1.2),
      peers_shape("RMS against a peer's, where both reach the target", 1);
  for (const Json& model : suite.at("models")) {
    const Json* mine = nullptr;
    for (const Json& result : model.at("results")) {
      const int percent = result.at("percent");
      const std::string where = model.at("name").get<std::string>() + " " + std::to_string(percent) + " %";
      if (is_ours(result)) {
        mine = &result;
        reached.add(where, reaches(model, result) ? 0 : 1);
        if (const auto ratio = shape_ratio(result); ratio && percent >= 10) shape.add(where, *ratio);
        if (const auto ratio = time_ratio(result, "seams", "decimation")) seams.add(where, *ratio);
        if (const auto ratio = time_ratio(result, "values", "decimation")) values.add(where, *ratio);
      } else if (mine && reaches(model, *mine) && reaches(model, result)) {
        const std::string against = where + " (" + result.at("contender").get<std::string>() + ")";
        peers_shape.add(against, rms(*mine) / rms(result));
        if (texture_rms(result) > 0) peers.add(against, texture_rms(*mine) / texture_rms(result));
      }
    }
  }
  out << "| goal | limit | held | missed |\n|---|---|---|---|\n";
  for (const Limit* limit : {&reached, &shape, &seams, &values, &peers_shape, &peers}) limit->write(out);
  out << "\n";
}

void write_pictures(std::ostream& out, const Json& suite) {
  bool begun = false;
  for (const Json& model : suite.at("models")) {
    if (model.at("picture").is_null()) continue;
    if (!begun)
      out << "### Pictures\n\nDrawn by " << suite.at("renderer").get<std::string>()
          << ", with a checker for a texture.\n\n";
    begun = true;
    std::string head = "| " + model.at("name").get<std::string>(), rule = "|---",
                body = "| ![](" + model.at("picture").get<std::string>() + ")";
    for (const Json& result : model.at("results")) {
      if (result.at("picture").is_null()) continue;
      head += " | " + result.at("contender").get<std::string>() + ", " +
              std::to_string(result.at("percent").get<int>()) + " %";
      rule += "|---";
      body += " | ![](" + result.at("picture").get<std::string>() + ")";
    }
    out << head << " |\n" << rule << "|\n" << body << " |\n\n";
  }
}

}  // namespace

void write_textured(std::ostream& out, const Json& suite) {
  out << "## Textured models\n\n"
      << "`mq` with its defaults. RMS: two-sided distance in ten-thousandths of the diagonal; without: that "
         "of the "
         "same model without texture or colours. Texture: RMS and largest error in texels of a texture of "
         "1,024; "
         "colours: in 255ths of a component. PSNR in dB over eight views. Time: decimation without "
         "attributes in "
         "ms (median of "
      << suite.at("rounds")
      << "), that with seams alone and with values as multiples of it, and the whole run's, "
      << "transfer of values included. A peer has no line where it left nothing, or failed.\n\n";
  if (!suite.at("why_no_pictures").is_null())
    out << "No pictures: " << suite.at("why_no_pictures").get<std::string>() << ".\n\n";
  write_goals(out, suite);
  for (const char* half : {"tuning", "held out", "given"}) write_half(out, suite, half);
  write_pictures(out, suite);
}

}  // namespace whittle::speed
