/// \file
/// 3MF: writing. Not with lib3mf, which writes six decimals of each coordinate, and other identifiers on each run.
#include "files/Choice.hh"
#include "files/Fault.hh"
#include "files/TextWriter.hh"
#include "files/Zip.hh"
#include "files/formats.hh"

namespace whittle::files {
namespace {

constexpr const char* kXml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

std::string model_of(const IndexedMesh& mesh, bool single_precision) {
  TextWriter out(single_precision);
  out << kXml
      << "<model unit=\"millimeter\" xml:lang=\"en-US\" "
         "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
         "<metadata name=\"Application\">whittle</metadata>\n"
         "<resources><object id=\"1\" type=\"model\"><mesh>\n<vertices>\n";
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
  out << "</triangles>\n</mesh></object></resources>\n<build><item objectid=\"1\"/></build>\n</model>\n";
  return out.take();
}

}  // namespace

std::string three_mf_bytes(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                           const WriteOptions& options, WriteReport& report) {
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
  zip.add("3D/3dmodel.model", model_of(mesh, options.single_precision));
  return zip.take();
}

}  // namespace whittle::files
