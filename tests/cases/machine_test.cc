// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/machine.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>

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

TEST(Machine, HasNoKernelsToSpeakOfWithoutOpenBlas) {
  EXPECT_EQ(blas_description(), "");
  EXPECT_EQ(blas_warning(), "");
}

}  // namespace
}  // namespace tiprub
