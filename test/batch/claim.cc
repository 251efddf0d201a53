#include "batch/Claim.hh"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <thread>
#include <vector>

#include "Folder.hh"
#include "catch.hh"

using namespace whittle::batch;
namespace fs = std::filesystem;
using std::chrono::milliseconds;

namespace {

constexpr milliseconds kShortLife{30};

/// A claim of a process on another machine.
void leave_claim(const fs::path& file) {
  std::ofstream(file) << "elsewhere-1\nanother-kernel\n";
}

/// Dates the claim by so many hours from now.
void date(const fs::path& file, int hours) {
  fs::last_write_time(file, fs::file_time_type::clock::now() + std::chrono::hours(hours));
}

std::optional<Claim> take(const fs::path& file) {
  return Bid(file).take();
}

}  // namespace

TEST_CASE("a claim has one owner, and is given back by its destructor") {
  const scratch::Folder folder;
  const fs::path file = folder.path() / "a";
  {
    const auto mine = take(file);
    REQUIRE(mine);
    CHECK(mine->is_mine());
    CHECK(mine->previous_owner().empty());
    Bid other(file);
    CHECK_FALSE(other.take());
    CHECK(other.owner_lives());
    CHECK(take(folder.path() / "b"));
  }
  CHECK(take(file));
  CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("the claim of a process that died on this machine is taken over at once") {
  const scratch::Folder folder;
  const fs::path file = folder.path() / "a";
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const auto claim = take(file);
    _exit(claim ? 0 : 1);  // without its destructor
  }
  int status = -1;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(status == 0);
  REQUIRE(fs::exists(file));
  date(file, 24);  // no clock is asked
  const auto mine = take(file);
  REQUIRE(mine);
  const std::string owner = mine->previous_owner();
  CHECK(owner.substr(owner.rfind('-') + 1) == std::to_string(child));
  CHECK_FALSE(take(file));
  CHECK(folder.entries() == 1);
}

TEST_CASE(
    "a claim from another machine is taken over once it has not changed for its life, whatever its date") {
  const scratch::Folder folder;
  for (const int hours : {-24, 24}) {
    const fs::path file = folder.path() / "a";
    leave_claim(file);
    date(file, hours);
    Bid bid(file, kShortLife);
    CHECK_FALSE(bid.take());
    CHECK_FALSE(bid.owner_lives());
    std::this_thread::sleep_for(2 * kShortLife);
    const auto mine = bid.take();
    REQUIRE(mine);
    CHECK(mine->previous_owner() == "elsewhere-1");
    CHECK(folder.entries() == 1);
  }
}

TEST_CASE("a claim from another machine that changes belongs to one that lives") {
  const scratch::Folder folder;
  const fs::path file = folder.path() / "a";
  leave_claim(file);
  date(file, -24);
  Bid bid(file, kShortLife);
  CHECK_FALSE(bid.take());
  date(file, -48);
  std::this_thread::sleep_for(2 * kShortLife);
  CHECK_FALSE(bid.take());
  CHECK(bid.owner_lives());
  CHECK(fs::exists(file));
}

TEST_CASE("a claim shows its life by its touches") {
  const scratch::Folder folder;
  const fs::path file = folder.path() / "a";
  const auto mine = take(file);
  REQUIRE(mine);
  date(file, -24);
  const auto before = fs::last_write_time(file);
  mine->touch();
  CHECK(fs::last_write_time(file) != before);
}

TEST_CASE("a claim that was taken over is not its first owner's any more, and is not given back by it") {
  const scratch::Folder folder;
  const fs::path file = folder.path() / "a";
  {
    const auto mine = take(file);
    REQUIRE(mine);
    fs::remove(file);
    leave_claim(file);
    CHECK_FALSE(mine->is_mine());
  }
  CHECK(fs::exists(file));
}

TEST_CASE("a claim goes to one of many threads that try at once") {
  const scratch::Folder folder;
  for (int round = 0; round < 50; ++round) {
    const fs::path file = folder.path() / std::to_string(round);
    std::atomic<int> owners{0};
    std::atomic<bool> go{false};
    std::vector<std::optional<Claim>> claims(4);
    std::vector<std::thread> threads;
    for (auto& claim : claims)
      threads.emplace_back([&] {
        while (!go) std::this_thread::yield();
        if (auto taken = take(file)) {
          ++owners;
          claim.emplace(std::move(*taken));
        }
      });
    go = true;
    for (auto& thread : threads) thread.join();
    CHECK(owners == 1);
  }
}

TEST_CASE("a folder that is not there cannot be claimed in") {
  CHECK_THROWS_AS(take("/no/such/folder/a"), fs::filesystem_error);
}
