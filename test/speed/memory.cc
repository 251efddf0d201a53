#include "speed/memory.hh"

#include <malloc.h>

#include <array>
#include <memory>
#include <new>
#include <thread>
#include <vector>

#include "catch.hh"

using whittle::speed::MemoryCount;

namespace {

/// What the allocator made of a block.
std::int64_t size_of(void* block) {
  return static_cast<std::int64_t>(malloc_usable_size(block));
}

/// A block that the compiler does not leave out.
std::unique_ptr<char[]> block() {
  auto made = std::make_unique<char[]>(100000);
  asm volatile("" : : "r"(made.get()) : "memory");
  return made;
}

struct alignas(64) Line {
  char bytes[64];
};

}  // namespace

TEST_CASE("the memory count is exact for a known block, and its peak outlives it") {
  std::int64_t size = 0, live = 0, after = 0, peak = 0;
  {
    const MemoryCount count;
    {
      const auto block = std::make_unique<char[]>(1000000);
      size = size_of(block.get());
      live = count.live();
    }
    after = count.live();
    peak = count.peak();
  }
  CHECK(size >= 1000000);
  CHECK(live == size);
  CHECK(after == 0);
  CHECK(peak == size);
}

TEST_CASE("the memory count's peak is of blocks alive at once, and can be restarted") {
  std::int64_t first = 0, both = 0, one_after_the_other = 0, restarted = 0;
  {
    MemoryCount count;
    {
      const auto a = block();
      first = size_of(a.get());
    }
    { const auto b = block(); }
    one_after_the_other = count.peak();
    const auto c = block();
    { const auto d = block(); }
    both = count.peak();
    count.restart_peak();
    restarted = count.peak();
  }
  CHECK(one_after_the_other == first);
  CHECK(both == 2 * first);
  CHECK(restarted == first);
}

TEST_CASE("the memory count sees every form of new and delete") {
  std::int64_t least = 0, left = 0, blocks = 0;
  {
    const MemoryCount count;
    auto* one = new (std::nothrow) std::array<char, 1000>;
    auto* several = new (std::nothrow) std::array<char, 1000>[2];
    auto* line = new (std::nothrow) Line;
    auto* lines = new Line[3];
    // Looked at, so that the compiler does not leave them out.
    for (void* block : {static_cast<void*>(one), static_cast<void*>(several), static_cast<void*>(line),
                        static_cast<void*>(lines)})
      blocks += size_of(block);
    least = count.live();
    delete one;
    delete[] several;
    delete line;
    delete[] lines;
    left = count.live();
  }
  CHECK(blocks >= 3000 + 4 * 64);
  CHECK(least == blocks);
  CHECK(left == 0);
}

TEST_CASE("the memory count sees aligned blocks and other threads, and nothing outside its lifetime") {
  const auto before = std::make_unique<char[]>(5000000);
  std::int64_t line = 0, live = 0, threads = 0;
  {
    const MemoryCount count;
    const auto aligned = std::make_unique<Line>();
    line = size_of(aligned.get());
    live = count.live();
    std::unique_ptr<char[]> blocks[2];
    std::thread([&] { blocks[0] = std::make_unique<char[]>(300000); }).join();
    std::thread([&] { blocks[1] = std::make_unique<char[]>(300000); }).join();
    threads = count.live() - live - size_of(blocks[0].get()) - size_of(blocks[1].get());
  }
  CHECK(live == line);
  CHECK(std::abs(threads) < 1000);  // a thread may keep a little of its own
}
