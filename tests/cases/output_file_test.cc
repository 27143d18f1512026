// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/output_file.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>

#include <fstream>
#include <functional>

#include "cases/program/errors.h"
#include "cases/program/signal_cleanup.h"
#include "tests/cases/full_disk.h"
#include "tests/cases/temporary_folder.h"

namespace tiprub {
namespace {

namespace fs = std::filesystem;

class OutputFiles : public TemporaryFolder {
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
  EXPECT_EQ(output.scratch(), path("model.tiprub.part.h5"));
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

TEST_F(OutputFiles, SayThatTheDiskIsFull) {
  const std::string text(1000, 'x');
  const auto write_text = [&] { write_file(path("table.csv"), [&](std::ostream& out) { out << text; }); };
  write_text();
  EXPECT_EQ(read(path("table.csv")), text);
  try {
    const FullDisk disk(text.size() - 1);
    write_text();
    FAIL();
  } catch (const RunError& error) {
    EXPECT_EQ(error.what(), path("table.csv").string() + ": can't be written: File too large");
  }
}

TEST_F(OutputFiles, FoldersAppearWholeAndReplaceOldOnes) {
  for (const std::string version : {"first", "second"}) {
    OutputFile output(path("report/"), OutputFile::Kind::folder);
    EXPECT_EQ(output.scratch(), path("report.tiprub.part"));
    fs::create_directory(output.scratch());
    write(output.scratch() / version, version);
    output.commit();
    EXPECT_TRUE(fs::exists(path("report") / version));
    EXPECT_EQ(entries(), 1);
  }
  EXPECT_FALSE(fs::exists(path("report") / "first"));
}

TEST_F(OutputFiles, LeftoversOfAnEarlierRunAreSweptAway) {
  write(path("model.tiprub.part.h5"), "half of an earlier run");
  OutputFile output(path("model.h5"));
  EXPECT_FALSE(fs::exists(output.scratch()));
}

/// `-o FOLDER` once emptied any folder that stood there: a case's own, with its model. Only what the program made
/// itself may go.
TEST_F(OutputFiles, AFolderWithSomebodysFilesIsRefusedAndKept) {
  fs::create_directories(path("case/notes"));
  write(path("case/notes/thesis.txt"), "mine");
  try {
    OutputFile output(path("case"), OutputFile::Kind::folder);
    FAIL();
  } catch (const RunError& error) {
    EXPECT_EQ(error.what(), path("case").string() +
                                ": can't be replaced: it holds notes/thesis.txt, which this program did not make; "
                                "move that away, or give another -o");
  }
  EXPECT_EQ(read(path("case/notes/thesis.txt")), "mine");
}

TEST_F(OutputFiles, AFileAddedToAMadeFolderIsKept) {
  {
    OutputFile output(path("report"), OutputFile::Kind::folder);
    fs::create_directory(output.scratch());
    write(output.scratch() / "report.html", "made");
    output.commit();
  }
  write(path("report/notes.txt"), "mine");
  EXPECT_THROW(OutputFile(path("report"), OutputFile::Kind::folder), RunError);
  EXPECT_EQ(read(path("report/notes.txt")), "mine");
}

TEST_F(OutputFiles, NamesThatAreNotOursAreKept) {
  write(path("model.part.h5"), "mine");
  fs::create_directory(path("report.old"));
  OutputFile output(path("model.h5"));
  write(output.scratch(), "new");
  output.commit();
  EXPECT_EQ(read(path("model.part.h5")), "mine");
  EXPECT_TRUE(fs::exists(path("report.old")));
}

/// Symptom: after all the work the file could not be put in the place of the folder, or "." could not be renamed, and
/// the list of files of "/" was read to its end first.
TEST_F(OutputFiles, ATargetOfAnotherKindOrWithoutANameIsRefusedBeforeTheWork) {
  fs::create_directory(path("empty"));
  write(path("model.h5"), "old");
  EXPECT_THROW(OutputFile(path("empty")), RunError);
  EXPECT_THROW(OutputFile(path("model.h5"), OutputFile::Kind::folder), RunError);
  for (const fs::path& name : {path("empty/."), path(".."), fs::path("/"), fs::path(".")}) {
    EXPECT_THROW(OutputFile(name, OutputFile::Kind::folder), RunError) << name;
    EXPECT_THROW(OutputLock{name}, RunError) << name;
  }
}

TEST_F(OutputFiles, ADeviceIsNoTarget) {
  EXPECT_THROW(OutputFile("/dev/null"), RunError);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

/// On a full disk a renamed file was empty: the disk's word is waited for first.
TEST_F(OutputFiles, AFullDiskKeepsTheOldFile) {
  if (!fs::is_character_file("/dev/full")) GTEST_SKIP() << "no /dev/full";
  write(path("model.h5"), "old");
  OutputFile output(path("model.h5"));
  fs::create_symlink("/dev/full", output.scratch());
  std::ofstream file(output.scratch());
  file << "new" << std::flush;
  EXPECT_FALSE(file.good());
  EXPECT_THROW(output.commit(), RunError);
  EXPECT_EQ(read(path("model.h5")), "old");
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
  {
    OutputFile output(path("report"), OutputFile::Kind::folder);
    fs::create_directory(output.scratch());
    write(output.scratch() / "index.html", "old");
    output.commit();
  }
  {
    OutputFile output(path("report"), OutputFile::Kind::folder);
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

/// Two runs on one output once mixed their scratch files.
TEST_F(OutputFiles, OneRunAtATimeOnAnOutput) {
  const OutputLock held(path("model.h5"));
  const int code = ending([&] {
    try {
      const OutputLock second(path("model.h5"));
    } catch (const RunError& error) {
      const std::string message = error.what();
      const bool told = message.find("model.h5: process " + std::to_string(getppid())) != std::string::npos &&
                        message.find("is writing it; wait for that, or give another -o") != std::string::npos;
      _exit(told ? 7 : 8);
    }
  });
  EXPECT_EQ(code, 7);
  const OutputLock other(path("response.h5"));  // another output is free
}

/// Symptom: a link named as the lock, in a case from elsewhere, led to a file of the user's, which was overwritten.
TEST_F(OutputFiles, ALockFollowsNoLink) {
  write(path("mine.txt"), "precious");
  fs::create_symlink("mine.txt", path(".model.h5.lock"));
  EXPECT_THROW(OutputLock{path("model.h5")}, RunError);
  EXPECT_EQ(read(path("mine.txt")), "precious");
  EXPECT_TRUE(fs::is_symlink(path(".model.h5.lock")));
}

TEST_F(OutputFiles, ALockEndsWithItsRunHoweverThatEnds) {
  EXPECT_EQ(ending([&] {
              const OutputLock held(path("model.h5"));
              raise(SIGTERM);
            }),
            128 + SIGTERM);
  EXPECT_EQ(entries(), 0);
  EXPECT_EQ(ending([&] {
              const OutputLock held(path("model.h5"));
              raise(SIGKILL);
            }),
            -1);
  { const OutputLock next(path("model.h5")); }
  EXPECT_EQ(entries(), 0);
}

std::string refusal(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs) {
  try {
    refuse_overwriting(outputs, inputs);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST_F(OutputFiles, AreNoInputsByWhateverName) {
  write(path("in.h5"), "in");
  fs::create_symlink("in.h5", path("link.h5"));
  fs::create_hard_link(path("in.h5"), path("hard.h5"));
  for (const fs::path& name : {path("in.h5"), path("link.h5"), path("hard.h5"), path("no/../in.h5")})
    EXPECT_EQ(refusal({name}, {path("other.h5"), path("in.h5")}),
              name.string() + ": would be written over " + path("in.h5").string() +
                  ", which this run reads or writes too; give it another name");
  EXPECT_EQ(refusal({path("out.h5"), ""}, {path("in.h5"), ""}), "");
}

TEST_F(OutputFiles, HaveEachItsOwnName) {
  EXPECT_EQ(refusal({path("x.h5"), path("y.h5"), ""}, {}), "");
  EXPECT_EQ(refusal({path("x.h5"), path("./x.h5")}, {}),
            path("./x.h5").string() + ": would be written over " + path("x.h5").string() +
                ", which this run reads or writes too; give it another name");
}

/// Under nohup the end of a session killed the run.
TEST_F(OutputFiles, IgnoredSignalsStayIgnored) {
  EXPECT_EQ(ending([&] {
              signal(SIGHUP, SIG_IGN);
              const OutputFile output(path("a.h5"));
              raise(SIGHUP);
              _exit(7);
            }),
            7);
}

TEST_F(OutputFiles, ASignalIsTold) {
  const fs::path said = path("said");
  EXPECT_EQ(ending([&] {
              const int file = open(said.c_str(), O_WRONLY | O_CREAT, 0600);
              dup2(file, STDERR_FILENO);
              announce_signals("tiprub-tiny");
              raise(SIGINT);
            }),
            128 + SIGINT);
  EXPECT_EQ(read(said), "tiprub-tiny: interrupted; what was finished is kept, and no half file is left\n");
}

}  // namespace
}  // namespace tiprub
