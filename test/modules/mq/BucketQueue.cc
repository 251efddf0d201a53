#include "whittle/mq/BucketQueue.hh"

#include <cmath>
#include <cstdint>

#include "catch.hh"

using whittle::mq::BucketQueue;

namespace {

/// The next item below a bucket.
bool pop(BucketQueue& queue, std::uint32_t& item, std::size_t end = BucketQueue::kBuckets) {
  return queue.advance(end) && queue.pop(item);
}

}  // namespace

TEST_CASE("a bucket queue goes up by quarters of an octave, and first in, first out in each") {
  CHECK(BucketQueue::bucket_of(0) == 0);
  CHECK(BucketQueue::bucket_of(-1) == 0);
  CHECK(BucketQueue::bucket_of(1) == BucketQueue::bucket_of(1.24f));
  CHECK(BucketQueue::bucket_of(1) + 1 == BucketQueue::bucket_of(1.25f));
  CHECK(BucketQueue::bucket_of(1) + 4 == BucketQueue::bucket_of(2));
  CHECK(BucketQueue::bucket_of(1) - 4 == BucketQueue::bucket_of(0.5f));
  CHECK(BucketQueue::bucket_of(NAN) == BucketQueue::kBuckets - 1);
  CHECK(BucketQueue::bucket_of(INFINITY) < BucketQueue::kBuckets);

  BucketQueue queue;
  std::uint32_t item = 0;
  queue.push(1, BucketQueue::bucket_of(3));
  queue.push(2, BucketQueue::bucket_of(0.1f));
  queue.push(3, BucketQueue::bucket_of(3.1f));
  REQUIRE(pop(queue, item));
  CHECK(item == 2);
  queue.push(4, BucketQueue::bucket_of(0.001f));  // below where the queue is: comes at once
  REQUIRE(pop(queue, item));
  CHECK(item == 4);
  REQUIRE(pop(queue, item));
  CHECK(item == 1);
  CHECK(queue.bucket() == BucketQueue::bucket_of(3));
  REQUIRE(pop(queue, item));
  CHECK(item == 3);
  CHECK_FALSE(pop(queue, item));
  queue.push(5, 9999);
  REQUIRE(pop(queue, item));
  CHECK(item == 5);
}

TEST_CASE("a bucket queue stops below a bucket, and goes on from there") {
  BucketQueue queue;
  std::uint32_t item = 0;
  CHECK(queue.next_bucket() == BucketQueue::kBuckets);
  queue.push(6, 700);
  CHECK(queue.next_bucket() == 700);
  CHECK(queue.size(700) == 1);
  CHECK_FALSE(pop(queue, item, 700));
  queue.push(7, 3);  // too late for its own bucket: the next one that is read
  REQUIRE(pop(queue, item, 701));
  CHECK(item == 6);
  REQUIRE(pop(queue, item, 701));
  CHECK(item == 7);
  CHECK(queue.size(700) == 0);
  CHECK_FALSE(pop(queue, item, 701));
}

TEST_CASE("a bucket queue's look ahead reaches into the next bucket and no further") {
  BucketQueue queue;
  for (const std::uint32_t item : {1u, 2u}) queue.push(item, 700);
  for (const std::uint32_t item : {3u, 4u}) queue.push(item, 701);
  queue.push(5, 702);
  std::uint32_t item = 0;
  REQUIRE(pop(queue, item));
  REQUIRE(item == 1);
  for (std::uint32_t ahead = 0; ahead < 3; ++ahead) {
    REQUIRE(queue.peek(ahead) != nullptr);
    CHECK(*queue.peek(ahead) == 2 + ahead);
  }
  CHECK(queue.peek(3) == nullptr);

  BucketQueue last;
  for (const std::uint32_t i : {6u, 7u}) last.push(i, BucketQueue::kBuckets - 1);
  REQUIRE(pop(last, item));
  REQUIRE(last.peek(0) != nullptr);
  CHECK(*last.peek(0) == 7);
  CHECK(last.peek(1) == nullptr);
}
