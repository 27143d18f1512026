// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/helpers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "cases/program/machine.h"

namespace tiprub {
namespace {

using namespace std::chrono_literals;

/// One thread has work, and the others have none.
void one_works(int threads, const std::function<void(Helpers&)>& work) {
  Helpers helpers;
  std::atomic<int> begun = 0;
  work_together(threads, [&] {
    helpers.begin();
    const bool first = begun++ == 0;
    while (begun < threads) std::this_thread::yield();
    if (first) work(helpers);
    helpers.help();
  });
}

TEST(Helpers, EachPartIsDoneOnceByAllThreads) {
  for (const int threads : {1, 2, 5}) {
    std::vector<std::atomic<int>> times(40);
    std::mutex mutex;
    std::set<std::thread::id> who;
    one_works(threads, [&](Helpers& helpers) {
      helpers.share(times.size(), [&](std::size_t i) {
        ++times[i];
        std::this_thread::sleep_for(2ms);
        const std::lock_guard lock(mutex);
        who.insert(std::this_thread::get_id());
      });
      for (const std::atomic<int>& each : times) EXPECT_EQ(each, 1);
    });
    EXPECT_EQ(who.size(), static_cast<std::size_t>(threads));
  }
}

/// A part may have parts itself, whichever thread does it.
TEST(Helpers, PartsOfPartsAreShared) {
  std::atomic<int> sum = 0;
  one_works(3, [&](Helpers& helpers) {
    helpers.share(
        4, [&](std::size_t i) { helpers.share(5, [&](std::size_t k) { sum += static_cast<int>(10 * i + k); }); });
    EXPECT_EQ(sum, 5 * 60 + 4 * 10);
  });
}

TEST(Helpers, AFailureReachesTheThreadThatShares) {
  std::atomic<int> done = 0;
  one_works(3, [&](Helpers& helpers) {
    EXPECT_THROW(helpers.share(9,
                               [&](std::size_t i) {
                                 ++done;
                                 if (i == 4) throw std::runtime_error("part 4");
                               }),
                 std::runtime_error);
  });
  EXPECT_EQ(done, 9);
}

TEST(Helpers, WithoutAnyTheThreadDoesAll) {
  int sum = 0;
  share(nullptr, 4, [&](std::size_t i) { sum += static_cast<int>(i); });
  EXPECT_EQ(sum, 6);
}

}  // namespace
}  // namespace tiprub
