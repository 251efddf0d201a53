#include "chart/Svg.hh"

#include <cstdio>

namespace whittle::chart {
namespace {

// Okabe and Ito's colours, a little darker on white and lighter on black for contrast.
constexpr char kStyle[] =
    ".wc{color-scheme:light dark}"
    ".wc text{font:12px system-ui,-apple-system,'DejaVu Sans',sans-serif;fill:#3b4148}"
    ".wc .small{font-size:10.5px;fill:#5c646d}.wc .value{font-size:10.5px}.wc .strong{font-weight:600}"
    ".wc .grid{stroke:#e1e4e8}.wc .axis{stroke:#8a929b}.wc .whisker{stroke:#22272c;stroke-width:1.2}"
    ".wc .claim{stroke:#b3003c;stroke-width:2;stroke-dasharray:5 3}.wc "
    ".claimtext{fill:#b3003c;font-size:10.5px}"
    ".wc .curve{fill:none;stroke-width:1.8}.wc .tick{stroke:#8a929b}"
    ".wc .f0{fill:#0072b2}.wc .f1{fill:#d55e00}.wc .f2{fill:#008f68}.wc .f3{fill:#b65e90}"
    ".wc .f4{fill:#c98800}.wc .f5{fill:#3a9bd1}.wc .f6{fill:#7a5fb5}.wc .f7{fill:#6b7278}.wc "
    ".f8{fill:#22272c}.wc .f9{fill:#8a5a2b}"
    ".wc .s0{stroke:#0072b2}.wc .s1{stroke:#d55e00}.wc .s2{stroke:#008f68}.wc .s3{stroke:#b65e90}"
    ".wc .s4{stroke:#c98800}.wc .s5{stroke:#3a9bd1}.wc .s6{stroke:#7a5fb5}.wc .s7{stroke:#6b7278}.wc "
    ".s8{stroke:#22272c}.wc .s9{stroke:#8a5a2b}"
    "@media(prefers-color-scheme:dark){.wc text{fill:#d6dbe1}.wc .small{fill:#a3abb4}"
    ".wc .grid{stroke:#333a42}.wc .axis,.wc .tick{stroke:#78818b}.wc .whisker{stroke:#f0f3f6}"
    ".wc .claim{stroke:#ff7a9c}.wc .claimtext{fill:#ff7a9c}"
    ".wc .f0{fill:#3fa7e0}.wc .f1{fill:#f08a45}.wc .f2{fill:#2fc79a}.wc .f3{fill:#dd93bd}"
    ".wc .f4{fill:#e9b44c}.wc .f5{fill:#7cc5ef}.wc .f6{fill:#ab95de}.wc .f7{fill:#a3abb4}.wc "
    ".f8{fill:#f0f3f6}.wc .f9{fill:#c99a6b}"
    ".wc .s0{stroke:#3fa7e0}.wc .s1{stroke:#f08a45}.wc .s2{stroke:#2fc79a}.wc .s3{stroke:#dd93bd}"
    ".wc .s4{stroke:#e9b44c}.wc .s5{stroke:#7cc5ef}.wc .s6{stroke:#ab95de}.wc .s7{stroke:#a3abb4}.wc "
    ".s8{stroke:#f0f3f6}.wc .s9{stroke:#c99a6b}}"
    "@media print{.wc text{fill:#000}}";

std::string tip_or_end(const std::string& tip, const char* element) {
  return tip.empty() ? "/>\n" : "><title>" + escape(tip) + "</title></" + element + ">\n";
}

}  // namespace

std::string coordinate(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2f", value);
  std::string out = text;
  while (out.back() == '0') out.pop_back();
  if (out.back() == '.') out.pop_back();
  return out == "-0" ? "0" : out;
}

std::string escape(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '&':
        safe += "&amp;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

Svg::Svg(int width, int height, const std::string& label) {
  const std::string w = std::to_string(width), h = std::to_string(height);
  body_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"wc\" role=\"img\" viewBox=\"0 0 " + w + " " + h +
          "\" width=\"" + w + "\" height=\"" + h + "\" aria-label=\"" + escape(label) + "\">\n<style>" +
          kStyle + "</style>\n";
}

void Svg::line(double x1, double y1, double x2, double y2, const std::string& style) {
  body_ += "<line class=\"" + style + "\" x1=\"" + coordinate(x1) + "\" y1=\"" + coordinate(y1) + "\" x2=\"" +
           coordinate(x2) + "\" y2=\"" + coordinate(y2) + "\"/>\n";
}

void Svg::rectangle(double x, double y, double width, double height, const std::string& style,
                    const std::string& tip) {
  body_ += "<rect class=\"" + style + "\" x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) + "\" width=\"" +
           coordinate(width) + "\" height=\"" + coordinate(height) + "\"" + tip_or_end(tip, "rect");
}

void Svg::text(double x, double y, const std::string& text, Anchor anchor, const std::string& style) {
  const char* const names[] = {"start", "middle", "end"};
  body_ += "<text x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) + "\" text-anchor=\"" +
           names[static_cast<int>(anchor)] + "\"" + (style.empty() ? "" : " class=\"" + style + "\"") + ">" +
           escape(text) + "</text>\n";
}

void Svg::text_upward(double x, double y, const std::string& text, const std::string& style) {
  body_ += "<text transform=\"translate(" + coordinate(x) + " " + coordinate(y) +
           ") rotate(-90)\" text-anchor=\"middle\"" + (style.empty() ? "" : " class=\"" + style + "\"") +
           ">" + escape(text) + "</text>\n";
}

void Svg::polyline(const std::string& points, const std::string& style) {
  body_ += "<polyline class=\"" + style + "\" points=\"" + points + "\"/>\n";
}

void Svg::marker(double x, double y, int series, const std::string& tip) {
  const std::string style = "f" + std::to_string(series % kColours);
  const auto at = [&](double dx, double dy) { return coordinate(x + dx) + "," + coordinate(y + dy) + " "; };
  switch (series % 4) {
    case 0:
      body_ += "<circle class=\"" + style + "\" cx=\"" + coordinate(x) + "\" cy=\"" + coordinate(y) +
               "\" r=\"4.2\"" + tip_or_end(tip, "circle");
      break;
    case 1:
      rectangle(x - 3.7, y - 3.7, 7.4, 7.4, style, tip);
      break;
    case 2:
      body_ += "<polygon class=\"" + style + "\" points=\"" + at(0, -5.4) + at(5.4, 0) + at(0, 5.4) +
               at(-5.4, 0) + "\"" + tip_or_end(tip, "polygon");
      break;
    default:
      body_ += "<polygon class=\"" + style + "\" points=\"" + at(0, -5) + at(4.9, 3.8) + at(-4.9, 3.8) +
               "\"" + tip_or_end(tip, "polygon");
  }
}

std::string Svg::finish() {
  return body_ + "</svg>\n";
}

}  // namespace whittle::chart
