/// \file
/// The few shapes that charts are drawn with, as SVG text that a page can hold as it is.
#pragma once

#include <string>

namespace whittle::chart {

/// How many series can be told apart by colour. Colours and markers repeat after that.
constexpr int kColours = 10;

/// `<`, `>`, `&` and quotes written so that XML and HTML take them for text.
std::string escape(const std::string& text);

enum class Anchor { start, middle, end };

/// A picture under construction. Colours come from style classes, so that they follow the reader's choice of
/// a light or a dark page; they are safe for the colour-blind.
class Svg {
 public:
  /// \param label  what the picture shows, for those who cannot see it.
  Svg(int width, int height, const std::string& label);

  void line(double x1, double y1, double x2, double y2, const std::string& style);
  void rectangle(double x, double y, double width, double height, const std::string& style,
                 const std::string& tip = "");
  void text(double x, double y, const std::string& text, Anchor anchor, const std::string& style = "");
  void text_upward(double x, double y, const std::string& text, const std::string& style = "");
  /// Points as "x,y x,y".
  void polyline(const std::string& points, const std::string& style);
  /// A circle, square, diamond or triangle, by the number of the series.
  void marker(double x, double y, int series, const std::string& tip = "");

  std::string finish();

 private:
  std::string body_;
};

/// Two decimals: a hundredth of a pixel.
std::string coordinate(double value);

}  // namespace whittle::chart
