// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/machine.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <vector>

#include "cases/program/errors.h"

namespace tiprub {
namespace {

/// A machine that is files.
class FakeMachine : public ::testing::Test {
 protected:
  FakeMachine() : root_(std::filesystem::path(::testing::TempDir()) / "fake_machine") {
    std::filesystem::remove_all(root_);
  }
  void write(const std::string& file, const std::string& text) {
    std::filesystem::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  std::filesystem::path root_;
};

TEST_F(FakeMachine, HasWhatTheKernelSays) {
  write("proc/meminfo", "MemTotal:       24000 kB\nMemFree:  100 kB\nMemAvailable:   1000 kB\n");
  EXPECT_EQ(available_memory(root_), 1000.0 * 1024);
}

TEST_F(FakeMachine, HasNoMoreThanItsControlGroupLeaves) {
  write("proc/meminfo", "MemAvailable:   1000 kB\n");
  write("sys/fs/cgroup/memory.max", "500000\n");
  write("sys/fs/cgroup/memory.current", "100000\n");
  EXPECT_EQ(available_memory(root_), 400000.0);
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "300000\n");
  write("sys/fs/cgroup/memory/memory.usage_in_bytes", "100000\n");
  EXPECT_EQ(available_memory(root_), 200000.0);
}

TEST_F(FakeMachine, IsNotLimitedByAGroupWithoutALimit) {
  write("proc/meminfo", "MemAvailable:   1000 kB\n");
  write("sys/fs/cgroup/memory.max", "max\n");
  write("sys/fs/cgroup/memory.current", "100000\n");
  EXPECT_EQ(available_memory(root_), 1000.0 * 1024);
}

// OpenBLAS asked for ever for a buffer that the limit refused.
TEST(Machine, RefusesALimitThatLeavesNoRoomForLibraries) {
#ifdef TIPRUB_SANITIZED
  GTEST_SKIP() << "the sanitizer maps more than any limit";
#endif
  EXPECT_NO_THROW(require_room_for_libraries());
  rlimit before{};
  getrlimit(RLIMIT_AS, &before);
  const rlimit narrow = {static_cast<rlim_t>(1) << 25, before.rlim_max};
  setrlimit(RLIMIT_AS, &narrow);
  const double mappable = mappable_memory();
  std::string message;
  try {
    require_room_for_libraries();
  } catch (const RunError& error) {
    message = error.what();
  }
  setrlimit(RLIMIT_AS, &before);
  EXPECT_LE(mappable, 1 << 25);
  EXPECT_EQ(message.rfind("not enough memory: about 160 MiB are needed to begin with, ", 0), 0u) << message;
}

TEST(Machine, EachNumberIsInOnePieceOfTheWork) {
  for (const int threads : {0, 1, 3, 50})
    for (const std::ptrdiff_t size : {0, 1, 6, 7}) {
      std::vector<std::atomic<int>> times(static_cast<std::size_t>(size));
      work_on_pieces(size, 3, threads, [&](std::ptrdiff_t first, std::ptrdiff_t count) {
        EXPECT_EQ(count, std::min<std::ptrdiff_t>(3, size - first));
        for (std::ptrdiff_t i = first; i < first + count; ++i) ++times[static_cast<std::size_t>(i)];
      });
      for (const std::atomic<int>& each : times) EXPECT_EQ(each, 1);
    }
}

TEST(Machine, NoPieceIsBegunAfterAFailure) {
  std::atomic<int> begun = 0;
  EXPECT_THROW(work_on_pieces(100, 1, 1,
                              [&](std::ptrdiff_t, std::ptrdiff_t) {
                                ++begun;
                                throw RunError("jammed");
                              }),
               RunError);
  EXPECT_EQ(begun, 1);
}

TEST(Machine, HasNoKernelsToSpeakOfWithoutOpenBlas) {
  EXPECT_EQ(blas_description(), "");
  EXPECT_EQ(blas_warning(), "");
}

}  // namespace
}  // namespace tiprub
