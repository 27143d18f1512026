// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/scratch_files.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "tests/cases/complaint.h"

namespace tiprub::reduce {
namespace {

std::filesystem::path parent() {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "scratch_folder_test";
  std::filesystem::create_directories(folder);
  return folder;
}

void write_something(const ScratchFolder& folder) {
  std::ofstream(folder.path() / "factor") << "entries";
}

TEST(ScratchFolder, GoesWithItsOwner) {
  std::filesystem::path path;
  {
    const ScratchFolder folder(parent());
    path = folder.path();
    write_something(folder);
    EXPECT_TRUE(std::filesystem::exists(path / "factor"));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(ScratchFolder, GoesWithAProcessThatIsKilled) {
  const pid_t process = fork();
  if (process == 0) {
    const ScratchFolder folder(parent());
    write_something(folder);
    kill(getpid(), SIGKILL);
  }
  waitpid(process, nullptr, 0);
  for (int i = 0; i < 100 && !std::filesystem::is_empty(parent()); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_TRUE(std::filesystem::is_empty(parent()));
}

TEST(ScratchFolder, SaysWhereItCantBeMade) {
  EXPECT_EQ(complaint<RunError>([] { ScratchFolder("/nowhere"); }),
            "/nowhere: no folder for factors can be made: No such file or directory");
}

}  // namespace
}  // namespace tiprub::reduce
