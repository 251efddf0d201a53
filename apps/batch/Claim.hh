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
/// The owner touches the file every now and then. A file that nobody has touched for a while belonged to a
/// process that died; somebody else may then take it over. In a race of several who do that at the same
/// instant two may come to hold it; so whatever is done under a claim must be allowed to happen twice.
class Claim {
 public:
  /// How long a claim that nobody touches is respected.
  static constexpr std::chrono::seconds kLife{60};

  /// \return nothing where somebody else has it.
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
