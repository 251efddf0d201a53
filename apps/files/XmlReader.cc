#include "files/XmlReader.hh"

#include <algorithm>

#include "files/Fault.hh"

namespace whittle::files {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

[[noreturn]] void throw_damaged_xml() {
  throw Fault("the XML in it is damaged");
}

}  // namespace

bool XmlReader::next() {
  for (;;) {
    at_ = text_.find('<', at_);
    if (at_ == std::string_view::npos) return false;
    const std::string_view rest = text_.substr(at_);
    if (rest.substr(0, 4) == "<!--") {
      skip_behind("-->");
    } else if (rest.substr(0, 9) == "<![CDATA[") {
      skip_behind("]]>");
    } else if (rest.substr(0, 2) == "<?") {
      skip_behind("?>");
    } else if (rest.substr(0, 2) == "<!") {
      throw Fault("XML with a document type is not read");
    } else {
      read_tag();
      return true;
    }
  }
}

std::string_view XmlReader::attribute(std::string_view name) const {
  for (const auto& [key, value] : attributes_)
    if (key == name) return value;
  return "";
}

bool XmlReader::has(std::string_view name) const {
  return std::any_of(attributes_.begin(), attributes_.end(),
                     [&](const auto& one) { return one.first == name; });
}

void XmlReader::skip_behind(std::string_view end) {
  const std::size_t found = text_.find(end, at_);
  if (found == std::string_view::npos) throw_damaged_xml();
  at_ = found + end.size();
}

void XmlReader::skip_blanks() {
  at_ = std::min(text_.find_first_not_of(kBlanks, at_), text_.size());
}

/// Behind the prefix.
std::string_view XmlReader::read_name() {
  const std::size_t end = std::min(text_.find_first_of(" \t\r\n=/>\"'<", at_), text_.size());
  std::string_view name = text_.substr(at_, end - at_);
  at_ = end;
  if (const std::size_t colon = name.rfind(':'); colon != std::string_view::npos)
    name.remove_prefix(colon + 1);
  if (name.empty()) throw_damaged_xml();
  return name;
}

void XmlReader::read_tag() {
  ++at_;
  closes_ = text_.substr(at_, 1) == "/";
  opens_ = !closes_;
  if (closes_) ++at_;
  name_ = read_name();
  attributes_.clear();
  for (;;) {
    skip_blanks();
    const std::string_view rest = text_.substr(at_, 2);
    if (rest.substr(0, 1) == ">") {
      ++at_;
      return;
    }
    if (rest == "/>") {
      at_ += 2;
      closes_ = true;
      return;
    }
    const std::string_view key = read_name();
    skip_blanks();
    if (text_.substr(at_, 1) != "=") throw_damaged_xml();
    ++at_;
    skip_blanks();
    const std::string_view quote = text_.substr(at_, 1);
    if (quote != "\"" && quote != "'") throw_damaged_xml();
    const std::size_t begin = at_ + 1;
    ++at_;
    skip_behind(quote);
    attributes_.emplace_back(key, text_.substr(begin, at_ - 1 - begin));
  }
}

}  // namespace whittle::files
