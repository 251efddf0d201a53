#include "files/Outputs.hh"

#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "files/Fault.hh"
#include "files/beside.hh"
#include "files/gltf_uri.hh"

namespace whittle::files {

namespace fs = std::filesystem;

namespace {

/// Whether the old file that this one is called after names the old companion.
bool belongs(const Companion& companion) {
  constexpr std::size_t most = std::size_t{1} << 28;  // bytes
  if (companion.owner.empty()) return false;
  const auto owner = bytes_of(companion.owner, most);
  const std::string name = companion.path.filename().string();
  return owner &&
         (owner->find(name) != std::string::npos || owner->find(encode_percents(name)) != std::string::npos);
}

}  // namespace

void Outputs::reads(const std::string& role, const fs::path& path) {
  inputs_.push_back({role, path, identity_of(path, STDIN_FILENO)});
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
    if (is_there && !belongs(companion))
      throw FileError(companion.path.string() +
                      ": would be written beside the result, but another file of this name is there; "
                      "move it away, or write to another folder");
    const std::string role = companion.path.string();
    add(role, companion.path);
    write(role, std::move(companion.bytes));
  }
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
  try {
    put_files();
  } catch (...) {
    for (auto file = files_.rbegin(); file != files_.rend(); ++file) file->file.take_back();
    files_.clear();
    throw;
  }
  for (const File& file : files_) naming(file.path, [&] { flush_folder(file.folder); });
  files_.clear();
}

}  // namespace whittle::files
