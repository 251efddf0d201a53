#include "speed/memory.hh"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

// operator new can reach nothing but globals.
std::atomic<bool> counting{false};
std::atomic<std::int64_t> live_bytes{0}, peak_bytes{0};

void* counted(void* block) {
  if (block && counting.load(std::memory_order_relaxed)) {
    const auto size = static_cast<std::int64_t>(malloc_usable_size(block));
    const std::int64_t live = live_bytes.fetch_add(size) + size;
    std::int64_t peak = peak_bytes.load();
    while (live > peak && !peak_bytes.compare_exchange_weak(peak, live)) continue;
  }
  return block;
}

void* try_take(std::size_t size) {
  return counted(std::malloc(size ? size : 1));
}

void* try_take(std::size_t size, std::align_val_t alignment) {
  const auto align = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(align, (size + align) / align * align));
}

template <typename... Arguments>
void* take(Arguments... arguments) {
  if (void* block = try_take(arguments...)) return block;
  throw std::bad_alloc();
}

void give_back(void* block) {
  if (block && counting.load(std::memory_order_relaxed))
    live_bytes.fetch_sub(static_cast<std::int64_t>(malloc_usable_size(block)));
  std::free(block);
}

}  // namespace

// All forms, since a sanitizer's runtime brings its own of each, and those do not call these.
void* operator new(std::size_t size) {
  return take(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return take(size, alignment);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return try_take(size);
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return try_take(size, alignment);
}
void* operator new[](std::size_t size) {
  return take(size);
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return take(size, alignment);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return try_take(size);
}
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return try_take(size, alignment);
}
void operator delete(void* block) noexcept {
  give_back(block);
}
void operator delete(void* block, std::size_t) noexcept {
  give_back(block);
}
void operator delete(void* block, std::align_val_t) noexcept {
  give_back(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
  give_back(block);
}
void operator delete(void* block, const std::nothrow_t&) noexcept {
  give_back(block);
}
void operator delete(void* block, std::align_val_t, const std::nothrow_t&) noexcept {
  give_back(block);
}
void operator delete[](void* block) noexcept {
  give_back(block);
}
void operator delete[](void* block, std::size_t) noexcept {
  give_back(block);
}
void operator delete[](void* block, std::align_val_t) noexcept {
  give_back(block);
}
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept {
  give_back(block);
}
void operator delete[](void* block, const std::nothrow_t&) noexcept {
  give_back(block);
}
void operator delete[](void* block, std::align_val_t, const std::nothrow_t&) noexcept {
  give_back(block);
}

namespace whittle::speed {

MemoryCount::MemoryCount() {
  live_bytes = 0;
  peak_bytes = 0;
  counting = true;
}

MemoryCount::~MemoryCount() {
  counting = false;
}

std::int64_t MemoryCount::live() const {
  return live_bytes;
}

std::int64_t MemoryCount::peak() const {
  return peak_bytes;
}

void MemoryCount::restart_peak() {
  peak_bytes = live_bytes.load();
}

}  // namespace whittle::speed
