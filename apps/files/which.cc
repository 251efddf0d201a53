/// \file
/// Which format a file has, by its name or by what is in it.
#include <algorithm>
#include <cctype>

#include "files/Fault.hh"
#include "files/TextReader.hh"
#include "files/Zip.hh"
#include "files/formats.hh"
#include "files/gzip.hh"

namespace whittle::files {
namespace {

struct ExtensionOf {
  std::string_view extension;
  Format format;
};

constexpr ExtensionOf extensions[] = {
    {".3mf", Format::three_mf}, {".glb", Format::glb}, {".gltf", Format::gltf}, {".obj", Format::obj},
    {".off", Format::off},      {".om", Format::om},   {".ply", Format::ply},   {".stl", Format::stl}};

/// Of all formats only glTF's JSON begins so.
bool is_json(std::string_view bytes) {
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && bytes[begin] == '{';
}

}  // namespace

std::vector<std::string> readable_extensions() {
  std::vector<std::string> all;
  for (const ExtensionOf& known : extensions) all.emplace_back(known.extension);
  return all;
}

std::vector<std::string> writable_extensions() {
  std::vector<std::string> all;
  for (const ExtensionOf& known : extensions) all.emplace_back(known.extension);
  return all;
}

std::string extension_of_format(const std::filesystem::path& path) {
  std::string extension = (is_gzip_name(path) ? path.stem() : path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

std::string whole_extension(const std::filesystem::path& path) {
  return extension_of_format(path) + (is_gzip_name(path) ? ".gz" : "");
}

Format format_of_extension(const std::string& extension) {
  for (const ExtensionOf& known : extensions)
    if (same_word(known.extension, extension)) return known.format;
  throw Fault((extension.empty() ? "no extension" : "unknown format " + in_quotes(extension)) +
              "; known are .3mf, .glb, .gltf, .obj, .off, .om, .ply and .stl");
}

bool format_of_content(std::string_view bytes, Format& format) {
  if (is_ply(bytes)) {
    format = Format::ply;
  } else if (is_off(bytes)) {
    format = Format::off;
  } else if (is_glb(bytes)) {
    format = Format::glb;
  } else if (is_om(bytes)) {
    format = Format::om;
  } else if (is_zip(bytes)) {
    format = Format::three_mf;
  } else if (is_json(bytes)) {
    format = Format::gltf;
  } else {
    return false;
  }
  return true;
}

Format likely_format(std::string_view bytes) {
  Format format{};
  if (format_of_content(bytes, format)) return format;
  // STL first: the header of a binary one may hold any text.
  if (may_be_stl(bytes)) return Format::stl;
  if (may_be_obj(bytes)) return Format::obj;
  throw Fault("the content is of no known format");
}

}  // namespace whittle::files
