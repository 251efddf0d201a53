/// \file
/// A bucketed priority queue of edges.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace whittle::mq {

/// A priority queue by buckets of a quarter of an octave of cost. The upper bits of the float are the bucket,
/// as positive floats are ordered as their bits are. Within a bucket items come first in, first out.
class BucketQueue {
 public:
  static constexpr int kBucketsPerOctave = 4;
  static constexpr std::size_t kBuckets = 1024;

  struct Entry {
    std::uint32_t item, bucket;
  };

  /// The bucket of a cost; the first for a negative cost, the last for NaN.
  static std::size_t bucket_of(float cost) {
    if (!(cost > 0)) return cost <= 0 ? 0 : kBuckets - 1;
    std::uint32_t bits = 0;
    static_assert(sizeof bits == sizeof cost);
    std::memcpy(&bits, &cost, sizeof bits);
    return bits >> 21;  // 8 bits of exponent, 2 of mantissa
  }

  /// The least cost in a bucket.
  static float cost_of(std::size_t bucket) {
    const auto bits = static_cast<std::uint32_t>(bucket << 21);
    float cost = 0;
    std::memcpy(&cost, &bits, sizeof cost);
    return cost;
  }

  /// An item for a bucket that has been passed goes to the current one.
  void push(std::uint32_t item, std::size_t bucket) {
    buckets_[bucket < at_ ? at_ : bucket < kBuckets ? bucket : kBuckets - 1].push_back(item);
  }

  /// Pushes many at once, after reserving each bucket.
  void push_all(const std::vector<Entry>& entries) {
    std::array<std::uint32_t, kBuckets> more{};
    for (const Entry& entry : entries) ++more[entry.bucket];
    for (std::size_t b = 0; b < kBuckets; ++b)
      if (more[b] > 0) buckets_[b].reserve(buckets_[b].size() + more[b]);
    for (const Entry& entry : entries) push(entry.item, entry.bucket);
  }

  /// Goes to the cheapest bucket that is not empty.
  /// \return false  there is none below bucket `end`.
  bool advance(std::size_t end = kBuckets) {
    while (at_ < end && read_ == buckets_[at_].size()) {
      if (at_ + 1 == kBuckets) return false;
      std::vector<std::uint32_t>().swap(buckets_[at_]);
      read_ = 0;
      ++at_;
    }
    return at_ < end;
  }

  /// Takes the next item of the current bucket.
  /// \return false  it is empty.
  bool pop(std::uint32_t& item) {
    const auto& items = buckets_[at_];
    if (read_ == items.size()) return false;
    item = items[read_++];
    return true;
  }

  /// The first bucket that is not empty, kBuckets if all are.
  std::size_t next_bucket() const {
    std::size_t bucket = at_;
    while (bucket < kBuckets && size(bucket) == 0) ++bucket;
    return bucket;
  }
  std::size_t size(std::size_t bucket) const { return buckets_[bucket].size() - (bucket == at_ ? read_ : 0); }

  std::size_t bucket() const { return at_; }  ///< the current one, where the last item came from

  /// The item `ahead` places after the next one, in the current bucket or the one after it; null if there is
  /// none. For prefetching.
  const std::uint32_t* peek(std::size_t ahead) const {
    const auto& items = buckets_[at_];
    const std::size_t i = read_ + ahead;
    if (i < items.size()) return &items[i];
    if (at_ + 1 == kBuckets) return nullptr;
    const auto& later = buckets_[at_ + 1];
    return i - items.size() < later.size() ? &later[i - items.size()] : nullptr;
  }

 private:
  std::array<std::vector<std::uint32_t>, kBuckets> buckets_;
  std::size_t at_ = 0, read_ = 0;
};

}  // namespace whittle::mq
