#include "attributes/Attribute.hh"

namespace whittle::attributes {

std::string to_string(const Attribute& attribute) {
  switch (attribute.kind) {
    case Kind::normal:
      return "normals";
    case Kind::colour:
      return "colours";
    case Kind::texture:
      return "texture coordinates";
    case Kind::skin:
      return "joints and weights";
    default:
      return "property '" + attribute.name + "'";
  }
}

}  // namespace whittle::attributes
