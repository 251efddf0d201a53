/// \file
/// Several processes, on several machines, share work through a folder.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace whittle::batch {

/// The right to work on one thing: a file that only one process can create. Given back by the destructor.
///
/// The owner touches the file periodically. A file untouched for a claim's lifetime belonged to a process that
/// died; any other may then take it over. If several do so at the same instant, two may come to hold it; so work
/// done under a claim must be safe to do twice.
class Claim {
 public:
  /// How long an untouched claim stays valid.
  static constexpr std::chrono::seconds kLife{60};

  /// \return nothing where another process holds it.
  /// \throw std::filesystem::filesystem_error  the folder cannot be written to.
  static std::optional<Claim> take(const std::filesystem::path& file, std::chrono::seconds life = kLife);

  Claim(Claim&& other) noexcept;
  Claim& operator=(Claim&&) = delete;
  ~Claim();

  /// To be called at least every third of the life.
  void touch() const;

 private:
  explicit Claim(std::filesystem::path file) : file_(std::move(file)) {}
  std::filesystem::path file_;
};

/// "host-1234": this process, among all that share the folder.
std::string process_name();

}  // namespace whittle::batch
