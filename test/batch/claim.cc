#include "batch/Claim.hh"

#include <sys/stat.h>

#include <atomic>
#include <fstream>
#include <thread>
#include <vector>

#include "Folder.hh"
#include "catch.hh"

using namespace whittle::batch;
namespace fs = std::filesystem;

namespace {

/// A claim of a process that died so many seconds ago.
void leave_claim(const fs::path& file, int seconds_ago) {
  std::ofstream(file) << "elsewhere-1\n";
  const auto then = fs::file_time_type::clock::now() - std::chrono::seconds(seconds_ago);
  fs::last_write_time(file, then);
}

}  // namespace

TEST_CASE("a claim has one owner, and is given back by its destructor") {
  const scratch::Folder folder;
  const fs::path file = folder.path() / "a";
  {
    const auto mine = Claim::take(file);
    REQUIRE(mine);
    CHECK_FALSE(Claim::take(file));
    CHECK(Claim::take(folder.path() / "b"));
  }
  CHECK(Claim::take(file));
  CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("the claim of a process that died is taken over, that of a living one is not") {
  const scratch::Folder folder;
  leave_claim(folder.path() / "dead", 120);
  leave_claim(folder.path() / "alive", 10);
  const auto dead = Claim::take(folder.path() / "dead");
  CHECK(dead);
  CHECK_FALSE(Claim::take(folder.path() / "alive"));
  // Nothing is left lying about.
  CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 2);
}

TEST_CASE("a claim that is touched does not grow old") {
  const scratch::Folder folder;
  const fs::path file = folder.path() / "a";
  const auto mine = Claim::take(file);
  REQUIRE(mine);
  fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::seconds(120));
  mine->touch();
  CHECK_FALSE(Claim::take(file));
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
        if (auto taken = Claim::take(file)) {
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
  CHECK_THROWS_AS(Claim::take("/no/such/folder/a"), fs::filesystem_error);
}
