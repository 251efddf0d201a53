/// \file
/// 3MF: writing. Not with lib3mf, which writes six decimals of each coordinate, and other identifiers on each run.
#include <algorithm>
#include <map>
#include <numeric>

#include "files/Choice.hh"
#include "files/Fault.hh"
#include "files/TextWriter.hh"
#include "files/Zip.hh"
#include "files/formats.hh"
#include "files/subset.hh"
#include "files/three_mf_names.hh"

namespace whittle::files {
namespace {

constexpr const char* kXml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

/// Some faces that stand in an object of their own.
struct Body {
  std::string name;
  std::vector<std::uint32_t> faces;
};

/// For each part the first of those that are one object with it: where they share a vertex, and where a file that knows of
/// materials or groups, too, calls them so.
class BodiesOfParts {
 public:
  BodiesOfParts(const IndexedMesh& mesh, const Parts& parts) : root_(parts.list.size()) {
    std::iota(root_.begin(), root_.end(), 0U);
    std::map<std::string, std::uint32_t> known;
    for (std::uint32_t i = 0; i < root_.size(); ++i) {
      const Part& part = parts.list[i];
      const bool is_object = part.material == Part::none && part.group.empty() && part.smoothing.empty();
      if (!is_object) join(known.emplace(part.object, i).first->second, i);
    }
    std::vector<std::uint32_t> at(mesh.points.size(), Part::none);
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
      for (const std::uint32_t vertex : mesh.triangles[f]) {
        if (at[vertex] != Part::none) join(at[vertex], parts.of_face[f]);
        at[vertex] = parts.of_face[f];
      }
  }

  std::uint32_t root(std::uint32_t part) {
    while (root_[part] != part) part = root_[part] = root_[root_[part]];
    return part;
  }

 private:
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    root_[std::max(a, b)] = std::min(a, b);
  }

  std::vector<std::uint32_t> root_;
};

std::vector<Body> bodies_of(const IndexedMesh& mesh, const Parts& parts) {
  if (parts.of_face.empty()) {
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    return {{"", std::move(all)}};
  }
  BodiesOfParts of(mesh, parts);
  std::map<std::uint32_t, Body> bodies;
  for (std::uint32_t f = 0; f < parts.of_face.size(); ++f) {
    const std::string& name = parts.list[parts.of_face[f]].object;
    Body& body = bodies[of.root(parts.of_face[f])];
    if (body.faces.empty()) body.name = name;
    if (body.name != name) body.name.clear();  // of several names
    body.faces.push_back(f);
  }
  std::vector<Body> out;
  for (auto& [root, body] : bodies) out.push_back(std::move(body));
  return out;
}

void write_object(TextWriter& out, const IndexedMesh& mesh, const std::string& name, std::uint64_t id) {
  out << "<object id=\"" << id << "\" type=\"model\"";
  if (!name.empty()) out << " name=\"" << xml_text(name) << "\"";
  out << "><mesh>\n<vertices>\n";
  for (const IndexedMesh::Point& point : mesh.points) {
    out << "<vertex x=\"";
    out.coordinate(point.x()) << "\" y=\"";
    out.coordinate(point.y()) << "\" z=\"";
    out.coordinate(point.z()) << "\"/>\n";
  }
  out << "</vertices>\n<triangles>\n";
  for (const auto& [a, b, c] : mesh.triangles)
    out << "<triangle v1=\"" << std::uint64_t{a} << "\" v2=\"" << std::uint64_t{b} << "\" v3=\""
        << std::uint64_t{c} << "\"/>\n";
  out << "</triangles>\n</mesh></object>";
}

std::string model_of(const IndexedMesh& mesh, const Parts& parts, const WriteOptions& options,
                     WriteReport& report) {
  TextWriter out(options.single_precision);
  out << kXml << "<model unit=\"" << (options.unit.empty() ? "millimeter" : options.unit)
      << "\" xml:lang=\"en-US\" "
         "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
         "<metadata name=\"Application\">whittle</metadata>\n"
         "<resources>";
  const std::vector<Body> bodies = bodies_of(mesh, parts);
  if (bodies.size() > 1) report.first_vertex.resize(mesh.points.size());
  std::uint32_t begin = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies.size() == 1) {
      write_object(out, mesh, bodies[i].name, 1);
      continue;
    }
    const FacesAlone alone = faces_alone(mesh, {}, bodies[i].faces);
    write_object(out, alone.mesh, bodies[i].name, i + 1);
    for (const std::uint32_t vertex : alone.vertices) report.first_vertex[vertex] = begin++;
  }
  out << "</resources>\n<build>";
  for (std::size_t i = 0; i < bodies.size(); ++i)
    out << "<item objectid=\"" << std::uint64_t{i + 1} << "\"/>";
  out << "</build>\n</model>\n";
  return out.take();
}

}  // namespace

std::string three_mf_bytes(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                           const WriteOptions& options, const Parts& parts, WriteReport& report) {
  choose(attributes, {}, report);
  if (mesh.triangles.empty()) throw Fault("not written: 3MF holds no mesh without faces");
  ZipWriter zip;
  zip.add("[Content_Types].xml",
          std::string(kXml) +
              "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
              "<Default Extension=\"rels\" "
              "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
              "<Default Extension=\"model\" "
              "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>"
              "</Types>\n");
  zip.add("_rels/.rels",
          std::string(kXml) +
              "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
              "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
              "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n");
  zip.add("3D/3dmodel.model", model_of(mesh, parts, options, report));
  return zip.take();
}

}  // namespace whittle::files
