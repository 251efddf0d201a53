/// \file
/// Words of 3MF.
#pragma once

#include <string>
#include <string_view>

namespace whittle::files {

/// Whether 3MF knows a unit of this name.
inline bool is_three_mf_unit(std::string_view name) {
  for (const std::string_view unit : {"micron", "millimeter", "centimeter", "inch", "foot", "meter"})
    if (name == unit) return true;
  return false;
}

/// XML's five characters with a name of their own, with what each is called in a text.
struct XmlName {
  char character;
  std::string_view text;
};
inline constexpr XmlName kXmlNames[] = {
    {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&apos;"}};

/// An attribute's text as what it says, on one line.
inline std::string xml_plain(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char c = static_cast<unsigned char>(text[i]) < ' ' ? ' ' : text[i];
    for (const XmlName& name : kXmlNames)
      if (text.substr(i, name.text.size()) == name.text) {
        c = name.character;
        i += name.text.size() - 1;
        break;
      }
    out += c;
  }
  return out;
}

/// The reverse.
inline std::string xml_text(std::string_view plain) {
  std::string out;
  for (const char c : plain) {
    std::string_view text = std::string_view(&c, 1);
    for (const XmlName& name : kXmlNames)
      if (name.character == c) text = name.text;
    if (static_cast<unsigned char>(c) < ' ') text = " ";
    out += text;
  }
  return out;
}

}  // namespace whittle::files
