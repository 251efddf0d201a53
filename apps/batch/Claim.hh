/// \file
/// Several processes, on several machines, share work through a folder.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "files/Descriptor.hh"

namespace whittle::batch {

/// The right to work on one thing: a file that only one process can create. Given back by the destructor.
///
/// The file is locked (flock) as long as its owner lives, and the owner touches it periodically. So processes
/// on one machine see at once whether an owner has died; those on other machines see it by a file that does not
/// change any more. No clock is compared with another. A claim can be lost, to a process that took the owner
/// for dead; ask is_mine() before what cannot be done twice.
class Claim {
 public:
  /// How long a claim that does not change stays valid.
  static constexpr std::chrono::seconds kLife{60};

  Claim(Claim&& other) noexcept;
  Claim& operator=(Claim&&) = delete;
  ~Claim();

  /// To be called at least every third of the life.
  void touch() const;

  /// False once another process has taken it over.
  bool is_mine() const;

  /// The process_name() of the owner that died, where this claim was taken over from one.
  const std::string& previous_owner() const { return previous_owner_; }

 private:
  friend class Bid;
  Claim(std::filesystem::path file, int descriptor) : file_(std::move(file)), descriptor_(descriptor) {}
  std::filesystem::path file_;
  std::string previous_owner_;
  files::Descriptor descriptor_;
};

/// An attempt at a claim, to be repeated while another process holds it.
class Bid {
 public:
  explicit Bid(std::filesystem::path file, std::chrono::milliseconds life = Claim::kLife)
      : file_(std::move(file)), life_(life) {}

  /// \return nothing where another process holds it
  /// \throw std::filesystem::filesystem_error  the folder cannot be written to.
  std::optional<Claim> take();

  /// Whether the last attempts have shown that the other process lives. Until then it is worth another attempt.
  bool owner_lives() const { return owner_lives_; }

 private:
  /// What changes when a claim is touched.
  struct Look {
    std::uint64_t file, seconds, nanoseconds;
    bool operator==(const Look& o) const {
      return file == o.file && seconds == o.seconds && nanoseconds == o.nanoseconds;
    }
  };
  bool owner_died(int file);
  std::optional<Claim> create() const;
  std::optional<Claim> take_over(int file);

  std::filesystem::path file_;
  std::chrono::milliseconds life_;
  std::optional<Look> seen_;
  std::chrono::steady_clock::time_point since_;
  std::string owner_;
  bool owner_lives_ = false;
};

/// "host-1234": this process, among all that share the folder.
std::string process_name();

}  // namespace whittle::batch
