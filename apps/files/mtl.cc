#include "files/mtl.hh"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>

#include "files/TextWriter.hh"
#include "files/beside.hh"

namespace whittle::files {
namespace {

constexpr std::size_t kMostLibrary = std::size_t{64} << 20;  // bytes

bool is_gap(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_gap(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_gap(text.back())) text.remove_suffix(1);
  return text;
}

/// Takes the first word off a text, and the blanks behind it.
std::string_view take_word(std::string_view& text) {
  text = trimmed(text);
  std::size_t end = 0;
  while (end < text.size() && !is_gap(text[end])) ++end;
  const std::string_view word = text.substr(0, end);
  text = trimmed(text.substr(end));
  return word;
}

std::optional<double> number(std::string_view word) {
  if (!word.empty() && word[0] == '+') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool is_all = error == std::errc() && end == word.data() + word.size() && !word.empty();
  return is_all && value >= -1e30 && value <= 1e30 ? std::optional(value) : std::nullopt;
}

/// Calls with each line, without its end.
template <typename Call>
void for_each_line(std::string_view text, Call call) {
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    call(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
}

bool names_image(std::string_view keyword) {
  for (const std::string_view other : {"bump", "disp", "decal", "refl", "norm"})
    if (keyword == other) return true;
  return keyword.substr(0, 4) == "map_" && keyword != "map_aat";
}

/// The name of the image at the end of what follows a keyword; before it there may be options.
std::string_view image_name(std::string_view text) {
  struct Option {
    std::string_view name;
    int values;
  };
  constexpr Option options[] = {{"-blendu", 1}, {"-blendv", 1},  {"-boost", 1},  {"-cc", 1},   {"-clamp", 1},
                                {"-bm", 1},     {"-imfchan", 1}, {"-texres", 1}, {"-type", 1}, {"-mm", 2},
                                {"-o", 3},      {"-s", 3},       {"-t", 3}};
  for (text = trimmed(text); !text.empty() && text[0] == '-';) {
    std::string_view rest = text;
    const std::string_view word = take_word(rest);
    const auto option = std::find_if(std::begin(options), std::end(options),
                                     [&](const Option& one) { return one.name == word; });
    if (option == std::end(options)) break;
    for (int i = 0; i < option->values; ++i) {
      std::string_view behind = rest;
      const std::string_view value = take_word(behind);
      if (option->values == 3 && i > 0 && !number(value)) break;  // one to three numbers
      rest = behind;
    }
    text = rest;
  }
  return text;
}

using ImageNumbers = std::map<std::filesystem::path, std::size_t>;

/// Reads what there is of the materials that are asked for.
class LibraryReader {
 public:
  /// \param images  those of all libraries, by their files
  LibraryReader(MeshFile& file, const std::filesystem::path& path, ImageNumbers& images)
      : file_(file), path_(path), images_(images) {
    for (Material& material : file.parts.materials) by_name_.emplace(material.name, &material);
  }

  void read(std::string_view text) {
    for_each_line(text, [&](std::string_view line) {
      const std::string_view keyword = take_word(line);
      if (keyword == "newmtl") begin(line);
      if (names_image(keyword)) add_image(keyword, std::string(image_name(line)));
      if (!current_) return;
      if (keyword == "Kd") read_colour(line);
      if (keyword == "d" || keyword == "Tr") read_opacity(keyword, line);
    });
  }

 private:
  /// The first of a name counts, as with all that look a name up.
  void begin(std::string_view name) {
    const auto found = by_name_.find(std::string(name));
    current_ = found == by_name_.end() ? nullptr : found->second;
    if (found != by_name_.end()) by_name_.erase(found);
  }

  void read_colour(std::string_view text) {
    std::array<double, 3> colour{};
    for (double& component : colour) {
      const std::optional<double> value = number(take_word(text));
      if (!value) return;  // "spectral" and "xyz", or nothing
      component = std::clamp(*value, 0.0, 1.0);
    }
    std::copy(colour.begin(), colour.end(), current_->colour.begin());
  }

  void read_opacity(std::string_view keyword, std::string_view text) {
    std::string_view word = take_word(text);
    if (word == "-halo") word = take_word(text);
    const std::optional<double> value = number(word);
    if (!value) return;
    current_->colour[3] = std::clamp(keyword == "d" ? *value : 1 - *value, 0.0, 1.0);
    current_->alpha = current_->colour[3] < 1 ? Material::Alpha::blend : Material::Alpha::opaque;
  }

  void add_image(std::string_view keyword, const std::string& name) {
    const Link link = follow(path_, name);
    if (!link.refusal.empty()) file_.report.refused.insert(link.refusal);
    if (!link.path.empty() && !link.is_there) file_.report.not_found.insert(name);
    if (!link.is_there) return;
    file_.files_beside.insert(link.path);
    if (keyword != "map_Kd" || !current_) return;
    std::error_code error;
    const auto [known, is_new] =
        images_.emplace(std::filesystem::weakly_canonical(link.path, error), file_.parts.images.size());
    if (is_new) file_.parts.images.push_back({name, link.path});
    current_->image = known->second;
  }

  MeshFile& file_;
  std::filesystem::path path_;
  ImageNumbers& images_;
  std::map<std::string, Material*> by_name_;
  Material* current_ = nullptr;
};

/// Takes the first name off a list: a word, or what stands in quotes. None where a comment begins.
std::string take_name(std::string_view& text) {
  text = trimmed(text);
  if (!text.empty() && text[0] == '#') text = {};
  const std::size_t quote = text.empty() || text[0] != '"' ? std::string_view::npos : text.find('"', 1);
  if (quote == std::string_view::npos) return std::string(take_word(text));
  std::string name(text.substr(1, quote - 1));
  text.remove_prefix(quote + 1);
  return name;
}

/// A name with blanks is one where there is such a file, else as many as there are words or quotes.
std::vector<Library> split_names(const std::vector<Library>& libraries, const std::filesystem::path& obj) {
  std::vector<Library> out;
  std::set<std::string> seen;
  const auto add = [&](const std::string& name) {
    if (name.empty() || !seen.insert(std::filesystem::path(name).lexically_normal().string()).second) return;
    out.push_back({name, follow(obj, name).path});
  };
  for (const Library& library : libraries) {
    std::string_view rest = library.name;
    if (follow(obj, library.name).is_there)
      add(library.name);
    else
      while (!rest.empty()) add(take_name(rest));
  }
  return out;
}

}  // namespace

void read_libraries(MeshFile& file, const std::filesystem::path& obj) {
  file.parts.libraries = split_names(file.parts.libraries, obj);
  ImageNumbers images;
  for (const Library& library : file.parts.libraries) {
    const Link link = follow(obj, library.name);
    const auto text = link.is_there ? bytes_of(link.path, kMostLibrary) : std::nullopt;
    if (text) file.files_beside.insert(link.path);
    if (!link.refusal.empty())
      file.report.refused.insert(link.refusal);
    else if (!text)
      file.report.not_found.insert(library.name);
    else if (!link.is_inside && !is_library(*text))
      file.report.refused.insert("'" + library.name + "', which is no library of materials");
    else
      LibraryReader(file, link.path, images).read(*text);
  }
}

bool is_library(std::string_view text) {
  bool has_material = false;
  for_each_line(text, [&](std::string_view line) { has_material |= take_word(line) == "newmtl"; });
  return has_material;
}

std::string with_images(std::string_view library,
                        const std::function<std::string(const std::string&)>& new_name) {
  std::string out;
  for_each_line(library, [&](std::string_view line) {
    std::string_view rest = line;
    const std::string_view keyword = take_word(rest);
    const std::string_view name = names_image(keyword) ? image_name(rest) : std::string_view();
    if (name.empty()) {
      out += line;
    } else {
      const auto begin = static_cast<std::size_t>(name.data() - line.data());
      out += line.substr(0, begin);
      out += new_name(std::string(name));
      out += line.substr(begin + name.size());
    }
    out += '\n';
  });
  if (!library.empty() && library.back() != '\n') out.pop_back();
  return out;
}

std::string mtl_text(const Parts& parts, const std::vector<std::string>& image_names) {
  TextWriter out(true);
  const std::vector<std::string> names = obj_material_names(parts.materials);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Material& material = parts.materials[i];
    out << (i > 0 ? "\n" : "") << "newmtl " << names[i] << "\nKd";
    for (std::size_t k = 0; k < 3; ++k) out << " " << static_cast<float>(material.colour[k]);
    out << "\n";
    if (material.alpha != Material::Alpha::opaque && material.colour[3] < 1)
      out << "d " << static_cast<float>(material.colour[3]) << "\n";
    if (material.image && !image_names[*material.image].empty()) {
      out << "map_Kd " << image_names[*material.image] << "\n";
      if (material.alpha != Material::Alpha::opaque)
        out << "map_d -imfchan m " << image_names[*material.image] << "\n";
    }
  }
  return out.take();
}

std::vector<std::string> obj_material_names(const std::vector<Material>& materials) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const Material& material : materials) {
    std::string name = material.name;
    for (char& c : name)
      if (static_cast<unsigned char>(c) < ' ') c = ' ';
    name = std::string(trimmed(name));
    while (name.empty() || !seen.insert(name).second)
      name = (name.empty() ? "material" : name) + "-" + std::to_string(names.size());
    names.push_back(name);
  }
  return names;
}

}  // namespace whittle::files
