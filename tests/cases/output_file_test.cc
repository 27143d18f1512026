// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/output_file.h"

#include <signal.h>
#include <sys/wait.h>

#include <functional>

#include "cases/program/errors.h"
#include "tests/cases/temporary_folder.h"

namespace tiprub {
namespace {

namespace fs = std::filesystem;

class OutputFiles : public test::TemporaryFolder {
 protected:
  /// Runs `work` in a process of its own and returns how it ended.
  static int ending(const std::function<void()>& work) {
    const pid_t child = fork();
    if (child == 0) {
      work();
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
};

TEST_F(OutputFiles, AppearWhole) {
  OutputFile output(path("model.h5"));
  EXPECT_EQ(output.scratch(), path("model.part.h5"));
  write(output.scratch(), "new");
  EXPECT_FALSE(fs::exists(path("model.h5")));
  output.commit();
  EXPECT_EQ(read(path("model.h5")), "new");
  EXPECT_EQ(entries(), 1);
}

TEST_F(OutputFiles, TheOldOneStandsUntilCommit) {
  write(path("model.h5"), "old");
  {
    OutputFile output(path("model.h5"));
    write(output.scratch(), "half");
    EXPECT_EQ(read(path("model.h5")), "old");
  }  // given up
  EXPECT_EQ(read(path("model.h5")), "old");
  EXPECT_EQ(entries(), 1);
  OutputFile output(path("model.h5"));
  write(output.scratch(), "new");
  output.commit();
  EXPECT_EQ(read(path("model.h5")), "new");
}

TEST_F(OutputFiles, FoldersAppearWholeAndReplaceOldOnes) {
  for (const std::string version : {"first", "second"}) {
    OutputFile output(path("report/"));
    EXPECT_EQ(output.scratch(), path("report.part"));
    fs::create_directory(output.scratch());
    write(output.scratch() / version, version);
    output.commit();
    EXPECT_TRUE(fs::exists(path("report") / version));
    EXPECT_EQ(entries(), 1);
  }
  EXPECT_FALSE(fs::exists(path("report") / "first"));
}

TEST_F(OutputFiles, LeftoversOfAnEarlierRunAreSweptAway) {
  write(path("model.part.h5"), "half of an earlier run");
  OutputFile output(path("model.h5"));
  EXPECT_FALSE(fs::exists(output.scratch()));
}

TEST_F(OutputFiles, RefuseAMissingFolder) {
  try {
    OutputFile output(path("nowhere/model.h5"));
    FAIL();
  } catch (const RunError& error) {
    EXPECT_EQ(error.what(),
              path("nowhere/model.h5").string() + ": can't be written: no folder " + path("nowhere").string());
  }
}

TEST_F(OutputFiles, FailToCommitWhatWasNeverWritten) {
  OutputFile output(path("model.h5"));
  EXPECT_THROW(output.commit(), RunError);
}

TEST_F(OutputFiles, AFailedCommitLeavesTheOldFolder) {
  fs::create_directory(path("report"));
  write(path("report") / "index.html", "old");
  {
    OutputFile output(path("report"));
    write(output.scratch(), "a file where a folder stands");
    EXPECT_THROW(output.commit(), RunError);
  }
  EXPECT_EQ(read(path("report") / "index.html"), "old");
  EXPECT_EQ(entries(), 1);
}

TEST_F(OutputFiles, SignalsRemoveTheHalfFileAndKeepTheOldOne) {
  write(path("model.h5"), "old");
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
    const int code = ending([&] {
      OutputFile output(path("model.h5"));
      write(output.scratch(), "half");
      raise(signal_number);
    });
    EXPECT_EQ(code, 128 + signal_number);
    EXPECT_EQ(read(path("model.h5")), "old");
    EXPECT_EQ(entries(), 1);
  }
}

TEST_F(OutputFiles, SignalsAfterCommitLeaveTheFile) {
  const int code = ending([&] {
    OutputFile output(path("model.h5"));
    write(output.scratch(), "whole");
    output.commit();
    raise(SIGTERM);
  });
  EXPECT_EQ(code, 128 + SIGTERM);
  EXPECT_EQ(read(path("model.h5")), "whole");
}

}  // namespace
}  // namespace tiprub
