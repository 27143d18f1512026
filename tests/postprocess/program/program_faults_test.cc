// SPDX-License-Identifier: GPL-3.0-or-later
// The executable where things go wrong around it: folders of other people, a gnuplot that fails, a second run.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "cases/program/output_file.h"
#include "program_fixture.h"

namespace fs = std::filesystem;

namespace tiprub::postprocess {
namespace {

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

const std::string whole_svg = "echo '<svg viewBox=\"0 0 1 1\"></svg>' > $n.svg; ";
const std::string whole_png = "printf '\\211PNG........IEND\\256\\102\\140\\202' > $n.png; ";

class ProgramFaults : public Program {
 protected:
  /// With a gnuplot of our own: a shell script that does this for each drawing $n that the script in $1 loads.
  static Outcome run_with_gnuplot(const std::string& body, const std::string& arguments) {
    const fs::path gnuplot = folder_ / "fake" / "gnuplot";
    write(gnuplot,
          "#!/bin/sh\n[ \"$1\" = --version ] && exit 0\n"
          "for n in $(sed -n \"s/^load '\\(.*\\)[.]gp'$/\\1/p\" \"$1\"); do\n" +
              body + "\ndone\n");
    fs::permissions(gnuplot, fs::perms::owner_all);
    return run(arguments, "PATH='" + gnuplot.parent_path().string() + "':$PATH ");
  }
  static Outcome run_quickly(const std::string& arguments) {
    return run_with_gnuplot(whole_svg + whole_png, arguments);
  }
  static void expect_one_line(const Outcome& outcome, const std::string& part) {
    EXPECT_EQ(outcome.exit_code, 1) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_NE(outcome.error.find(part), std::string::npos) << outcome.error;
  }
};

/// Once a report took the place of whatever folder stood there, a case with its model included. The refusal comes
/// before the work: here nothing is there to work on.
TEST_F(ProgramFaults, LeavesFoldersOfOthersAlone) {
  write(folder_ / "mine/thesis.txt", "mine");
  write(folder_ / "nested/figures/thesis.txt", "mine");
  fs::create_directories(folder_ / "linked");
  fs::create_symlink(folder_ / "mine", folder_ / "linked/figures");
  fs::create_symlink(folder_ / "mine", folder_ / "link");
  for (const std::string name : {"mine", "mine/", "./mine/../mine", "nested", "linked", "link"})
    expect_one_line(run("case.toml absent.h5 absent.h5 -o " + name), "which this program did not make");
  expect_one_line(run("case.toml absent.h5 absent.h5 -o ."), "give the output a name of its own");
  EXPECT_EQ(text_of(folder_ / "mine/thesis.txt"), "mine");
  EXPECT_EQ(text_of(folder_ / "nested/figures/thesis.txt"), "mine");
  EXPECT_TRUE(fs::is_symlink(folder_ / "linked/figures"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
}

TEST_F(ProgramFaults, ReplacesItsOwnReportAndNothingBesideIt) {
  const char* const neighbours[] = {"own.old/notes.txt", "own.part/notes.txt", "own.part.h5", "x.part.h5"};
  for (const char* beside : neighbours) write(folder_ / beside, "mine");
  ASSERT_EQ(run_quickly("case.toml model.h5 response.h5 -o own").exit_code, 0);
  const Outcome again = run_quickly("case.toml model.h5 response.h5 -o own/");
  EXPECT_EQ(again.exit_code, 0) << again.error;
  for (const char* beside : neighbours) EXPECT_EQ(text_of(folder_ / beside), "mine") << beside;
  write(folder_ / "own/notes.txt", "mine");
  expect_one_line(run_quickly("case.toml model.h5 response.h5 -o own"), "own: can't be replaced: it holds notes.txt");
  EXPECT_EQ(text_of(folder_ / "own/notes.txt"), "mine");
}

TEST_F(ProgramFaults, TriesTheFolderBeforeTheWork) {
  for (const std::string name : {"case.toml/report", "absent/report", "/proc/report", "/dev/null/report"})
    expect_one_line(run("case.toml absent.h5 absent.h5 -o " + name), name + ": can't be written");
  expect_one_line(run("case.toml absent.h5 absent.h5 -o /dev/null"), "/dev/null: can't be replaced");
}

TEST_F(ProgramFaults, KeepsTheOldReportWhenGnuplotFails) {
  ASSERT_EQ(run_quickly("case.toml model.h5 response.h5 -o kept").exit_code, 0);
  const std::string old = text_of(folder_ / "kept/report.html");
  const auto fails = [&](const std::string& gnuplot, const std::string& message) {
    expect_one_line(run_with_gnuplot(gnuplot, "case.toml model.h5 response.h5 -o kept"), message);
    EXPECT_EQ(text_of(folder_ / "kept/report.html"), old);
    EXPECT_FALSE(fs::exists(folder_ / "kept.tiprub.part"));
  };
  fails("printf 'line 3:\n\n\033[1mwhat?\n' >&2; exit 2",
        "interaction_map_leading_edge: gnuplot could not draw it: line 3:   [1mwhat?");
  fails("exit 2", "interaction_map_leading_edge: gnuplot could not draw it: it gave no reason");
  fails("kill -9 $$", "interaction_map_leading_edge: gnuplot could not draw it: signal 9 ended it");
  fails(": > $n.svg; : > $n.png", "interaction_map_leading_edge.svg: is not whole; is the disk full?");
  fails(whole_png + "echo '<svg><path' > $n.svg", "interaction_map_leading_edge.svg: is not whole");
  fails(whole_svg + "printf '\\211PNG............' > $n.png", "interaction_map_leading_edge.png: is not whole");
}

/// A title with markup, a template's place, shell, gnuplot and terminal commands.
TEST_F(ProgramFaults, ShowsHostileTextsAsTheyStand) {
  write(folder_ / "hostile.toml",
        R"(title = "<script>alert(1)</script> {{record}} '\"q\"' `touch ran` _{x}^2 \u001b[1m"
[postprocess]
)");
  const Outcome outcome = run_quickly("hostile.toml model.h5 response.h5 -o hostile");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const std::string page = text_of(folder_ / "hostile/report.html");
  EXPECT_NE(page.find("<h1>&lt;script&gt;alert(1)&lt;/script&gt; {{record}} '&quot;q&quot;' `touch ran` _{x}^2 "
                      "\xEF\xBF\xBD[1m</h1>"),
            std::string::npos)
      << page.substr(0, page.find("</h1>"));
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_EQ(page.find('\x1b'), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "ran") || fs::exists(folder_ / "hostile/figures/ran"));
}

TEST_F(ProgramFaults, WorksInFoldersOfAnyName) {
  const std::string name = "L\xC3\xA4ufer \"b\" $(touch ran) ; `touch ran`\nx";
  fs::create_directories(folder_ / name);
  for (const char* file : {"case.toml", "model.h5", "response.h5"})
    fs::copy_file(folder_ / file, folder_ / name / file);
  const auto quoted = [&](const char* file) { return " '" + name + "/" + file + "'"; };
  const Outcome outcome = run_quickly(quoted("case.toml") + quoted("model.h5") + quoted("response.h5") + " -q -o" +
                                      quoted("report 'of' it"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_TRUE(fs::exists(folder_ / name / "report of it/figures/casing.png"));
  EXPECT_FALSE(fs::exists(folder_ / "ran"));
}

TEST_F(ProgramFaults, SaysWhoIsWritingTheReport) {
  const OutputLock held(folder_ / "held");
  expect_one_line(run("case.toml model.h5 response.h5 -o held"),
                  "held: process " + std::to_string(getpid()) + " on ");
}

}  // namespace
}  // namespace tiprub::postprocess
