#include "files/Outputs.hh"

#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "files/Fault.hh"
#include "files/beside.hh"
#include "files/own_companions.hh"

namespace whittle::files {

namespace fs = std::filesystem;

void Outputs::reads(const std::string& role, const fs::path& path) {
  inputs_.push_back({role, path, identity_of(path, STDIN_FILENO)});
}

void Outputs::reads_beside(const std::string& role, const std::set<fs::path>& files) {
  for (const fs::path& file : files) {
    const Identity identity = identity_of(file, STDIN_FILENO);
    for (const Path& output : outputs_)
      if (identity.regular && identity.same(output.identity))
        throw FileError(output.role + " would overwrite " + file.string() + ", which " + role + " names");
    inputs_.push_back({role, file, identity});
  }
}

void Outputs::add(const std::string& role, const fs::path& path, const std::string& in_place_of) {
  if (path.empty()) return;
  naming(path, [&] { find_target(path); });
  const Identity identity = identity_of(path, STDOUT_FILENO);
  for (const Path& input : inputs_)
    if (input.role != in_place_of && input.identity.regular && input.identity.same(identity))
      throw FileError(role + " would overwrite " + input.role + ": " + input.path.string());
  for (const Path& output : outputs_)
    if (output.identity.same(identity))
      throw FileError(output.role + " and " + role + " would both be written to " +
                      display_name(output.path));
  outputs_.push_back({role, path, identity});
}

const Outputs::Path* Outputs::find(const std::string& role) const {
  const auto at =
      std::find_if(outputs_.begin(), outputs_.end(), [&](const Path& output) { return output.role == role; });
  return at == outputs_.end() ? nullptr : &*at;
}

bool Outputs::has(const std::string& role) const {
  return find(role) != nullptr;
}

void Outputs::write(const std::string& role, std::string bytes) {
  const Path* output = find(role);
  if (!output) return;
  naming(output->path, [&] {
    const Target target = find_target(output->path);
    if (target.stream)
      streams_.push_back({output->path, target, std::move(bytes)});
    else
      files_.emplace_back(output->path, target, bytes);
  });
}

void Outputs::write_beside(std::vector<Companion> companions) {
  for (Companion& companion : companions) {
    std::error_code error;
    if (has(companion.path.string())) continue;  // of another output: the same one
    const bool is_there = fs::exists(fs::symlink_status(companion.path, error));
    if (is_there && bytes_of(companion.path, companion.bytes.size()) == companion.bytes) continue;
    if (is_there)
      throw FileError(companion.path.string() +
                      ": would be written beside the result, but another file of this name is there; "
                      "move it away, or write to another folder");
    const std::string role = companion.path.string();
    add(role, companion.path);
    naming(companion.path,
           [&] { files_.emplace_front(companion.path, find_target(companion.path), companion.bytes); });
  }
}

bool Outputs::replaces_input() const {
  for (const Path& input : inputs_)
    for (const Path& output : outputs_)
      if (input.identity.same(output.identity)) return true;
  return false;
}

void Outputs::put_files() {
  // The last one needs no way back.
  const auto last = std::prev(files_.end());
  for (auto file = files_.begin(); file != last; ++file) naming(file->path, [&] { file->file.name(); });
  for (auto file = files_.begin(); file != last; ++file) naming(file->path, [&] { file->file.try_put(); });
  naming(last->path, [&] { last->file.put(); });
}

void Outputs::commit() {
  for (const Stream& stream : streams_)
    naming(stream.path, [&] { write_stream(stream.target, stream.bytes); });
  streams_.clear();
  if (files_.empty()) return;
  OldCompanions old;
  std::vector<fs::path> kept;
  for (const File& file : files_) {
    old.look_at(file.path);
    kept.push_back(file.path);
  }
  if (!replaces_input())
    for (const Path& input : inputs_) kept.push_back(input.path);
  try {
    put_files();
  } catch (...) {
    for (auto file = files_.rbegin(); file != files_.rend(); ++file) file->file.take_back();
    files_.clear();
    throw;
  }
  for (const File& file : files_) naming(file.path, [&] { flush_folder(file.folder); });
  old.remove_unnamed(kept);
  files_.clear();
}

}  // namespace whittle::files
