#include "batch/Items.hh"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

#include "files/MeshFile.hh"
#include "text/hash.hh"

namespace whittle::batch {
namespace {

namespace fs = std::filesystem;

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_any_of(const std::vector<std::string>& extensions, const fs::path& path) {
  return std::find(extensions.begin(), extensions.end(), files::extension_of_format(path)) !=
         extensions.end();
}

bool is_mesh(const fs::path& path) {
  return is_any_of(files::readable_extensions(), path);
}

/// A path as the name of one file: what would be understood otherwise is written as %XX. The end of a long one
/// is a hash, as a file's name has 255 bytes at most and the names of what is remembered add to it.
std::string flat(const std::string& path) {
  std::string out;
  for (const char c : path) {
    if (c == '/')
      out += "%2F";
    else if (c == '%')
      out += "%25";
    else
      out += c;
  }
  constexpr std::size_t kLongest = 120, kKept = 80;
  return out.size() <= kLongest ? out : out.substr(0, kKept) + "%%" + text::hash(path);
}

/// Input and where its result goes below the folder of results.
struct Found {
  std::vector<std::pair<fs::path, fs::path>> meshes;
  std::vector<std::string> problems;
};

/// One folder after the other, so that only one is open at a time, however deep they are.
class Walk {
 public:
  Walk(const fs::path& source, const fs::path& out) : source_(source), out_(out) {}

  Found all() {
    waiting_.push_back(source_);
    while (!waiting_.empty()) {
      const fs::path folder = std::move(waiting_.back());
      waiting_.pop_back();
      list(folder);
    }
    std::sort(found_.meshes.begin(), found_.meshes.end());
    std::sort(found_.problems.begin(), found_.problems.end());
    return std::move(found_);
  }

 private:
  void list(const fs::path& folder) {
    std::error_code error;
    fs::directory_iterator at(folder, error);
    for (; !error && at != fs::directory_iterator(); at.increment(error)) visit(*at);
    if (error) note(folder, error);
  }

  void note(const fs::path& path, const std::error_code& error) {
    found_.problems.push_back(path.string() + ": cannot be listed: " + error.message());
  }

  void visit(const fs::directory_entry& entry) {
    std::error_code error;
    const fs::file_type kind = entry.symlink_status(error).type();
    if (kind == fs::file_type::none || kind == fs::file_type::unknown) return note(entry.path(), error);
    if (kind == fs::file_type::directory) {
      // What a batch remembers has names of meshes too.
      if (entry.path().filename() != ".whittle" && !fs::equivalent(entry.path(), out_, error))
        waiting_.push_back(entry.path());
      return;
    }
    if (!is_mesh(entry.path())) return;
    // A link that leads nowhere is a mesh that cannot be read, which is to be told.
    const fs::file_type type = entry.status(error).type();
    if (type == fs::file_type::regular || type == fs::file_type::not_found || type == fs::file_type::none ||
        type == fs::file_type::unknown)
      found_.meshes.emplace_back(entry.path(), entry.path().lexically_relative(source_));
  }

  const fs::path &source_, &out_;
  std::vector<fs::path> waiting_;
  Found found_;
};

Found in_manifest(const fs::path& manifest) {
  std::string text = files::read_file(manifest);
  if (text.rfind("\xEF\xBB\xBF", 0) == 0) text.erase(0, 3);  // a byte-order mark, as some editors write it
  std::istringstream lines(text);
  Found found;
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back()))) line.pop_back();
    if (line.empty() || line[0] == '#') continue;
    if (!is_mesh(line) || line.find('\0') != std::string::npos)
      throw BatchError(manifest.string() + ":" + std::to_string(number) + ": not the name of a mesh file");
    const fs::path path = line;
    found.meshes.emplace_back(path.is_absolute() ? path : manifest.parent_path() / path, path.filename());
  }
  return found;
}

/// What the result of a mesh is called by its name and the format.
/// \param keeps  whether the extension that it had becomes a part of the name: packed.ply.gz becomes packed.ply.stl
fs::path name_of_result(fs::path name, const std::string& format, bool keeps) {
  if (format.empty() && is_any_of(files::writable_extensions(), name)) return name;
  const std::string whole = files::whole_extension(name), old = files::extension_of_format(name);
  std::string text = name.string();
  text.resize(text.size() - whole.size());
  if (keeps) text += old;
  return text + "." + (format.empty() ? "glb" : format);  // glTF's one-file form
}

/// Those that would be called the same keep their extensions in their names.
std::vector<fs::path> names_of_results(const std::vector<std::pair<fs::path, fs::path>>& meshes,
                                       const std::string& format) {
  std::map<fs::path, std::size_t> wanted;
  for (const auto& [in, name] : meshes) ++wanted[name_of_result(name, format, false)];
  std::vector<fs::path> names;
  for (const auto& [in, name] : meshes) {
    const fs::path plain = name_of_result(name, format, false);
    names.push_back(wanted[plain] > 1 ? name_of_result(name, format, true) : plain);
  }
  return names;
}

/// Which file it is, whatever it is called.
using Identity = std::pair<dev_t, ino_t>;

bool identify(const fs::path& path, Identity& identity) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return false;
  identity = {status.st_dev, status.st_ino};
  return true;
}

/// \throw BatchError  a result would replace the input of another
void check_inputs_stay(const std::vector<Item>& items) {
  std::map<Identity, const Item*> inputs;
  Identity identity;
  for (const Item& item : items)
    if (identify(item.in, identity)) inputs.emplace(identity, &item);
  for (const Item& item : items) {
    if (!identify(item.out, identity)) continue;
    const auto input = inputs.find(identity);
    if (input != inputs.end() && input->second != &item)
      throw BatchError("the result of " + item.in.string() + " would replace the input " +
                       input->second->in.string());
  }
}

}  // namespace

bool case_counts_in(fs::path folder) {
  std::error_code error;
  for (folder = fs::absolute(folder, error); !fs::is_directory(folder, error) && folder.has_relative_path();)
    folder = folder.parent_path();
  std::string made = (folder / ".whittle-case-XXXXXX").string();
  if (::mkdtemp(made.data()) == nullptr) return true;
  const fs::path name = fs::path(made).filename();
  std::string other = name.string();
  std::transform(other.begin(), other.end(), other.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  const bool is_found = fs::exists(folder / other, error);
  fs::remove(made, error);
  return !is_found;
}

Listing list_items(const fs::path& source, const fs::path& out, const std::string& format,
                   bool (*case_counts)(fs::path)) {
  std::error_code error;
  const bool is_folder = fs::is_directory(source, error);
  if (!is_folder && !fs::exists(source, error))
    throw BatchError(
        source.string() + ": there is no folder of this name, nor a list of meshes" +
        (source.string().find_first_of("*?[") == std::string::npos
             ? ""
             : "; a pattern is not one: name the folder, or a text file with a mesh on each line"));
  if (!is_folder && is_mesh(source))
    throw BatchError(
        source.string() +
        ": is a mesh; batch takes a folder, or a text file with the name of a mesh on each line");
  Found found = is_folder ? Walk(source, out).all() : in_manifest(source);
  Listing listing;
  listing.problems = std::move(found.problems);
  std::map<fs::path, fs::path> taken;
  std::map<std::string, fs::path> in_lower_case;
  std::optional<bool> counts;  // once that matters
  const std::vector<fs::path> names = names_of_results(found.meshes, format);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const fs::path &in = found.meshes[i].first, &relative = names[i];
    const auto [other, is_new] = taken.emplace(relative, in);
    if (!is_new)
      throw BatchError(in.string() + " and " + other->second.string() + " would both become " +
                       (out / relative).string() +
                       ": rename one, or put them into folders of their own and name their parent");
    const auto [similar, is_alone] = in_lower_case.emplace(lower_case(relative.string()), in);
    if (!is_alone && !counts) counts = case_counts(out);
    if (!is_alone && !*counts)
      throw BatchError(in.string() + " and " + similar->second.string() + " would both become " +
                       (out / relative).string() + ", as case does not count there: rename one");
    listing.items.push_back({in, out / relative, flat(relative.string())});
  }
  check_inputs_stay(listing.items);
  return listing;
}

}  // namespace whittle::batch
