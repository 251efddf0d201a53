#include "files/ply_header.hh"

#include <algorithm>
#include <optional>

#include "files/Fault.hh"

namespace whittle::files {
namespace {

/// Names are compared with each other, so an absurd header would take for ever.
constexpr std::size_t most_declarations = 1000;

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr TypeName type_names[] = {
    {"char", PlyType::int8},       {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},     {"short", PlyType::int16},     {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},   {"uint16", PlyType::uint16},   {"int", PlyType::int32},
    {"int32", PlyType::int32},     {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
    {"float", PlyType::float32},   {"float32", PlyType::float32}, {"double", PlyType::float64},
    {"float64", PlyType::float64},
};

PlyType parse_type(std::string_view word) {
  for (const TypeName& known : type_names)
    if (known.name == word) return known.type;
  throw Fault("unknown type " + in_quotes(word));
}

std::string parse_name(std::string_view word) {
  if (word.empty()) throw Fault("a name is missing");
  return std::string(word);
}

template <typename Named>
bool contains(const std::vector<Named>& all, const std::string& name) {
  return std::any_of(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
}

class HeaderReader {
 public:
  explicit HeaderReader(TextReader& in) : in_(in) {}

  PlyHeader read() {
    if (!in_.next_line() || in_.word() != "ply") throw Fault("not a PLY file: the first line is not 'ply'");
    std::string_view keyword;
    do {
      if (!in_.next_line()) throw Fault("the file is cut off: the header has no end_header");
      keyword = in_.word();
      read_statement(keyword);
    } while (keyword != "end_header");
    if (!encoding_) throw Fault("the header has no format");
    header_.encoding = *encoding_;
    return std::move(header_);
  }

 private:
  void read_statement(std::string_view keyword) {
    if (keyword == "comment" && in_.word() == "TextureFile") read_image();
    if (keyword == "obj_info") read_info();
    if (keyword == "comment" || keyword == "obj_info") return;
    if (keyword == "format")
      read_format();
    else if (keyword == "element")
      read_element();
    else if (keyword == "property")
      read_property();
    else if (keyword != "end_header")
      throw Fault("unknown header line " + in_quotes(keyword));
    if (const std::string_view word = in_.word(); !word.empty()) throw Fault("unexpected " + in_quotes(word));
  }

  void read_image() {
    const std::string_view name = in_.rest_of_line();
    if (name.empty()) return;
    if (header_.images.size() == most_declarations)
      throw Fault("the header names more than " + std::to_string(most_declarations) + " images");
    header_.images.emplace_back(name);
  }

  /// Of a range image; anything else may stand there, too.
  void read_info() {
    const std::string_view name = in_.word(), value = in_.word();
    if (value.empty() || value.find_first_not_of("0123456789") != std::string_view::npos) return;
    if (name == "num_cols") header_.grid_columns = parse_count(value);
    if (name == "num_rows") header_.grid_rows = parse_count(value);
  }

  void read_format() {
    if (encoding_) throw Fault("a second format");
    const std::string_view word = in_.word();
    if (word == "ascii")
      encoding_ = PlyEncoding::ascii;
    else if (word == "binary_little_endian")
      encoding_ = PlyEncoding::little_endian;
    else if (word == "binary_big_endian")
      encoding_ = PlyEncoding::big_endian;
    else
      throw Fault("unknown format " + in_quotes(word));
    if (const std::string_view version = in_.word(); version != "1.0")
      throw Fault("unknown version " + in_quotes(version));
  }

  void read_element() {
    count_declaration();
    PlyElement element;
    element.name = parse_name(in_.word());
    element.count = in_.count();
    if (contains(header_.elements, element.name)) throw Fault("a second element " + in_quotes(element.name));
    header_.elements.push_back(std::move(element));
  }

  void read_property() {
    count_declaration();
    if (header_.elements.empty()) throw Fault("a property before any element");
    PlyProperty property;
    std::string_view type = in_.word();
    if (type == "list") {
      property.is_list = true;
      property.length_type = parse_type(in_.word());
      if (!ply_is_integer(property.length_type)) throw Fault("the length of a list is not an integer");
      type = in_.word();
    }
    property.type = parse_type(type);
    property.name = parse_name(in_.word());
    std::vector<PlyProperty>& properties = header_.elements.back().properties;
    if (contains(properties, property.name)) throw Fault("a second property " + in_quotes(property.name));
    properties.push_back(std::move(property));
  }

  void count_declaration() {
    if (++declarations_ > most_declarations)
      throw Fault("the header has more than " + std::to_string(most_declarations) +
                  " elements and properties");
  }

  TextReader& in_;
  PlyHeader header_;
  std::optional<PlyEncoding> encoding_;
  std::size_t declarations_ = 0;
};

}  // namespace

std::size_t ply_size(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      break;
  }
  return 8;
}

bool ply_is_integer(PlyType type) {
  return type != PlyType::float32 && type != PlyType::float64;
}

const PlyElement* PlyHeader::find(const std::string& name) const {
  for (const PlyElement& element : elements)
    if (element.name == name) return &element;
  return nullptr;
}

PlyHeader read_ply_header(TextReader& in) {
  return HeaderReader(in).read();
}

}  // namespace whittle::files
