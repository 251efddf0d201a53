/// \file
/// 3MF: reading. Not with lib3mf, which a file of a kilobyte keeps busy for ever: components of components, doubled 40
/// times.
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "files/Fault.hh"
#include "files/MeshBuilder.hh"
#include "files/TextReader.hh"
#include "files/XmlReader.hh"
#include "files/Zip.hh"
#include "files/formats.hh"
#include "files/three_mf_names.hh"

namespace whittle::files {
namespace {

using Transform = Eigen::Matrix<double, 3, 4>;

/// An object at a place.
struct Instance {
  std::string model, id;
  Transform transform;
};

struct Object {
  std::string name;
  std::vector<IndexedMesh::Point> points;
  std::vector<std::array<std::int64_t, 3>> triangles;
  std::vector<Instance> components;
};

Transform identity() {
  Transform transform = Transform::Zero();
  transform.leftCols<3>().setIdentity();
  return transform;
}

/// Twelve numbers, column by column; points are columns.
Transform parse_transform(std::string_view text) {
  if (text.empty()) return identity();
  std::size_t line = 0;
  TextReader in(text, line, {});
  Transform transform;
  try {
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 3; ++row) transform(row, column) = parse_real<double>(in.word_anywhere());
    if (in.word_anywhere().empty()) return transform;
  } catch (const Fault&) {
    // As with too many of them.
  }
  throw Fault("a transform that is not twelve numbers: " + in_quotes(text));
}

Transform product(const Transform& outer, const Transform& inner) {
  Transform result;
  result.leftCols<3>() = outer.leftCols<3>() * inner.leftCols<3>();
  result.col(3) = outer.leftCols<3>() * inner.col(3) + outer.col(3);
  return result;
}

/// What is not known of these is said, and changes nothing about the meshes; or it is where objects stand.
bool is_known_extension(std::string_view name_space) {
  for (const char* known : {"http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
                            "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
                            "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02"})
    if (name_space == known) return true;
  return false;
}

/// \throw Fault  the model asks for an extension that is not known
void check_three_mf_extensions(const XmlReader& model) {
  std::string_view rest = model.attribute("requiredextensions");
  constexpr std::string_view blanks = " \t\r\n";
  while ((rest = rest.substr(std::min(rest.find_first_not_of(blanks), rest.size()))) != "") {
    const std::string_view prefix = rest.substr(0, rest.find_first_of(blanks));
    rest.remove_prefix(prefix.size());
    if (const std::string_view name_space = model.attribute(prefix); !is_known_extension(name_space))
      throw Fault("it needs the extension " + in_quotes(name_space.empty() ? prefix : name_space) +
                  ", which is not supported");
  }
}

/// In the archive names have no slash in front.
std::string_view without_slash(std::string_view path) {
  if (path.substr(0, 1) == "/") path.remove_prefix(1);
  return path;
}

/// Where the model is.
std::string root_model(const ZipReader& zip) {
  const std::string relations = zip.unpacked("_rels/.rels");
  constexpr std::string_view type = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
  XmlReader xml(relations);
  while (xml.next())
    if (xml.opens() && xml.name() == "Relationship" && xml.attribute("Type") == type)
      return std::string(without_slash(xml.attribute("Target")));
  throw Fault("the archive has no 3D model");
}

class Package {
 public:
  Package(std::string_view bytes, MeshFile& file, const ReadOptions& options)
      : zip_(bytes),
        file_(file),
        builder_(file, options),
        budget_(std::max<std::size_t>(std::size_t{16} << 20, 64 * bytes.size())) {}

  void read() {
    const std::string root = root_model(zip_);
    read_model(root, true);
    for (const Instance& item : items_) add(item, identity(), 0);
    if (parts_ > 1) file_.report.parts = parts_;
    const bool is_named = std::any_of(file_.parts.list.begin(), file_.parts.list.end(),
                                      [](const Part& part) { return !part.object.empty(); });
    if (parts_ <= 1 && !is_named) file_.parts = {};
  }

 private:
  using Name = std::pair<std::string, std::string>;  ///< the model's, the object's

  /// Objects may stand in other models of the archive, which are read once.
  void read_model(const std::string& model, bool is_root) {
    if (!models_.insert(model).second) return;
    const std::string text = zip_.unpacked(model);
    Object* object = nullptr;
    XmlReader xml(text);
    while (xml.next()) {
      if (xml.name() == "object" && xml.closes()) object = nullptr;
      if (!xml.opens()) continue;
      if (xml.name() == "object" && !xml.closes())
        object = &new_object(model, xml);
      else if (xml.name() == "model")
        begin_model(xml, is_root);
      else if (xml.name() == "metadata" && xml.attribute("name") != "Application")
        builder_.ignore_besides("metadata");
      else if (xml.name() == "item" && is_root)
        items_.push_back(instance(model, xml));
      else if (object != nullptr)
        read_part(xml, model, *object);
    }
  }

  Object& new_object(const std::string& model, const XmlReader& xml) {
    note_properties(xml);
    const auto [object, is_new] = objects_.emplace(Name(model, xml.attribute("id")), Object());
    if (!is_new) throw Fault("a second object " + in_quotes(xml.attribute("id")));
    object->second.name = xml_plain(xml.attribute("name"));
    return object->second;
  }

  void read_part(const XmlReader& xml, const std::string& model, Object& object) {
    if (xml.name() == "vertex") {
      const auto number = [&](const char* axis) { return parse_real<double>(xml.attribute(axis)); };
      const double x = number("x"), y = number("y"), z = number("z");
      object.points.emplace_back(x, y, z);
    } else if (xml.name() == "triangle") {
      const auto corner = [&](const char* name) { return parse_integer(xml.attribute(name)); };
      const std::int64_t a = corner("v1"), b = corner("v2"), c = corner("v3");
      object.triangles.push_back({a, b, c});
      note_properties(xml);
    } else if (xml.name() == "component") {
      object.components.push_back(instance(model, xml));
    } else if (xml.name() == "beam") {
      builder_.ignore("beams");
    }
  }

  static Instance instance(const std::string& model, const XmlReader& xml) {
    return {xml.has("path") ? std::string(without_slash(xml.attribute("path"))) : model,
            std::string(xml.attribute("objectid")), parse_transform(xml.attribute("transform"))};
  }

  void begin_model(const XmlReader& xml, bool is_root) {
    check_three_mf_extensions(xml);
    if (is_root) take_unit(xml.attribute("unit"));
  }

  void take_unit(std::string_view unit) {
    if (is_three_mf_unit(unit))
      file_.unit = unit;
    else if (!unit.empty())
      builder_.ignore("the unit, " + in_quotes(unit) + ", which 3MF does not know");
  }

  void note_properties(const XmlReader& xml) {
    if (xml.has("pid")) builder_.ignore_besides("materials, colours and texture");
  }

  /// An archive of some bytes can name an object any number of times.
  void charge(std::size_t count, std::size_t bytes_each) {
    if (count > budget_ / bytes_each) throw Fault("the build is too many times as large as the file");
    budget_ -= count * bytes_each;
  }

  void add(const Instance& instance, const Transform& outer, int depth) {
    constexpr int deepest = 64;
    if (depth > deepest)
      throw Fault("components within components, more than " + std::to_string(deepest) + " deep");
    charge(1, 256);
    read_model(instance.model, false);
    const auto found = objects_.find(Name(instance.model, instance.id));
    if (found == objects_.end()) throw Fault("there is no object " + in_quotes(instance.id));
    const Object& object = found->second;
    const Transform transform = product(outer, instance.transform);
    if (!object.triangles.empty() || !object.points.empty()) add_mesh(object, transform);
    for (const Instance& component : object.components) add(component, transform, depth + 1);
  }

  void add_mesh(const Object& object, const Transform& transform) {
    charge(object.points.size(), sizeof(IndexedMesh::Point));
    charge(object.triangles.size(), sizeof(IndexedMesh::Triangle));
    const std::size_t begin = file_.mesh.points.size();
    if (begin + object.points.size() >= no_vertex) throw Fault("more vertices than 32-bit indices can name");
    const bool stays = transform == identity();
    for (const IndexedMesh::Point& point : object.points) {
      IndexedMesh::Point at = point;
      if (!stays) at = transform.leftCols<3>() * point + transform.col(3);
      builder_.add_point(at.x(), at.y(), at.z());
    }
    const bool mirrored = transform.leftCols<3>().determinant() < 0;
    std::vector<std::uint32_t> corners(3);
    for (const auto& triangle : object.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = builder_.index(triangle[k], object.points.size());
        corners[k] = vertex == no_vertex ? no_vertex : static_cast<std::uint32_t>(begin + vertex);
      }
      if (mirrored) std::swap(corners[1], corners[2]);
      builder_.add_face(corners);
    }
    file_.parts.of_face.resize(file_.mesh.triangles.size(), static_cast<std::uint32_t>(parts_));
    file_.parts.list.push_back({Part::none, object.name, "", ""});
    ++parts_;
  }

  ZipReader zip_;
  MeshFile& file_;
  MeshBuilder builder_;
  std::size_t budget_;
  std::size_t parts_ = 0;
  std::set<std::string> models_;
  std::map<Name, Object> objects_;
  std::vector<Instance> items_;
};

}  // namespace

MeshFile read_three_mf(std::string_view bytes, const ReadOptions& options) {
  MeshFile file;
  file.report.format = "3MF";
  Package(bytes, file, options).read();
  return file;
}

}  // namespace whittle::files
