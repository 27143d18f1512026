// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/command_line.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>
#include <stdexcept>

#include "cases/program/case_file.h"
#include "cases/program/errors.h"

namespace tiprub::command_line_test {
namespace {

/// A tiny stage and what a run of it does.
struct Ending {
  int code = -1;
  std::string out, err;
};

enum class Captured { yes, no };

Ending run(std::vector<std::string> words, const std::function<void(const StageArguments&)>& body,
           Captured captured = Captured::yes) {
  words.insert(words.begin(), "tiprub-tiny");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  const Stage stage{.name = "tiprub-tiny",
                    .summary = "Does little.",
                    .inputs = {{"case.toml", "the scene"}, {"sector.msh", "one sector"}},
                    .output = "tiny.h5",
                    .tables = [](const CaseFile& file) { return "title = " + file.title() + "\n"; }};
  Ending ending;
  if (captured == Captured::no) {
    ending.code = run_stage(static_cast<int>(argv.size()), argv.data(), stage, body);
    return ending;
  }
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  ending.code = run_stage(static_cast<int>(argv.size()), argv.data(), stage, body);
  ending.out = ::testing::internal::GetCapturedStdout();
  ending.err = ::testing::internal::GetCapturedStderr();
  return ending;
}

const std::vector<std::string> inputs = {"a.toml", "b.msh"};

std::vector<std::string> with(std::vector<std::string> more) {
  more.insert(more.begin(), inputs.begin(), inputs.end());
  return more;
}

void expect_untouched(const std::vector<std::string>& words, const std::string& phrase) {
  const Ending ending = run(words, [](const StageArguments&) { FAIL() << "the body ran"; });
  EXPECT_EQ(ending.code, 2);
  EXPECT_NE(ending.err.find(phrase), std::string::npos) << ending.err;
  EXPECT_NE(ending.err.find("; see tiprub-tiny --help\n"), std::string::npos) << ending.err;
  EXPECT_EQ(ending.out, "");
}

TEST(CommandLine, GivesTheBodyItsArguments) {
  StageArguments seen;
  const Ending ending = run(inputs, [&](const StageArguments& arguments) { seen = arguments; });
  EXPECT_EQ(ending.code, 0);
  EXPECT_EQ(seen.inputs, (std::vector<std::filesystem::path>{"a.toml", "b.msh"}));
  EXPECT_EQ(seen.output, "tiny.h5");
  EXPECT_EQ(seen.verbosity, Verbosity::normal);
  EXPECT_EQ(seen.action, Action::run);
  EXPECT_EQ(ending.out + ending.err, "");
}

/// "program", then wall time and processor time [s], and processors.
TEST(CommandLine, NotesHowLongARunTook) {
  const std::filesystem::path note = std::filesystem::path(testing::TempDir()) / "times.csv";
  std::filesystem::remove(note);
  EXPECT_EQ(run(with({"--times", note.string()}), [](const StageArguments&) { throw InputError("wrong"); }).code, 2);
  EXPECT_EQ(run(with({"--times", note.string(), "--check"}), [](const StageArguments&) {}).code, 0);
  EXPECT_FALSE(std::filesystem::exists(note)) << "of work that was not done";
  const auto sleep = [](const StageArguments&) { usleep(20000); };
  ASSERT_EQ(run(with({"--times", note.string()}), sleep).code, 0);
  std::ifstream stream(note);
  std::string header, program, wall, processor, processors;
  std::getline(stream, header);
  std::getline(stream, program, ',');
  std::getline(stream, wall, ',');
  std::getline(stream, processor, ',');
  std::getline(stream, processors);
  EXPECT_EQ(header, "program,wall time [s],processor time [s],processors");
  EXPECT_EQ(program, program_version("tiprub-tiny"));
  EXPECT_TRUE(std::stod(wall) >= 0.02 && std::stod(wall) < 60) << wall;
  EXPECT_TRUE(std::stod(processor) > 0 && std::stoi(processors) >= 1) << processor << processors;
}

TEST(CommandLine, KnowsItsOptions) {
  StageArguments seen;
  const auto look = [&](const StageArguments& arguments) { seen = arguments; };
  EXPECT_EQ(run(with({"-o", "x.h5", "--check", "-q"}), look).code, 0);
  EXPECT_EQ(seen.output, "x.h5");
  EXPECT_EQ(seen.action, Action::check);
  EXPECT_EQ(seen.verbosity, Verbosity::quiet);
  EXPECT_EQ(run({"--set", "a.b=1", "a.toml", "--set", "a.c=[1, 2]", "b.msh"}, look).code, 0);
  EXPECT_EQ(seen.settings, (std::vector<std::string>{"a.b=1", "a.c=[1, 2]"}));
  EXPECT_EQ(seen.inputs, (std::vector<std::filesystem::path>{"a.toml", "b.msh"}));
  EXPECT_EQ(run(with({"-v"}), look).code, 0);
  EXPECT_EQ(seen.verbosity, Verbosity::verbose);
}

TEST(CommandLine, TurnsEachKindOfErrorIntoItsExitCode) {
  const auto ending_of = [](auto error) { return run(inputs, [=](const StageArguments&) { throw error; }); };
  EXPECT_EQ(ending_of(InputError("wrong")).code, 2);
  EXPECT_EQ(ending_of(RunError("failed")).code, 1);
  EXPECT_EQ(ending_of(std::logic_error("odd")).code, 1);
  EXPECT_EQ(ending_of(InputError("wrong")).err, "tiprub-tiny: error: wrong\n");
  EXPECT_EQ(ending_of(RunError("failed")).err, "tiprub-tiny: error: failed\n");
  EXPECT_EQ(ending_of(std::bad_alloc()).code, 1);
  EXPECT_EQ(ending_of(std::bad_alloc()).err, "tiprub-tiny: error: not enough memory\n");
}

TEST(CommandLine, RefusesWhatItDoesNotKnow) {
  expect_untouched({}, "case.toml is required");
  expect_untouched({"a.toml"}, "sector.msh is required");
  expect_untouched(with({"c.h5"}), "c.h5");
  expect_untouched(with({"--fast"}), "--fast");
  expect_untouched(with({"-q", "-v"}), "excludes");
  expect_untouched(with({"-o"}), "--output");
  expect_untouched(with({"--set"}), "--set");
}

/// "--bogus" said that case.toml is required.
TEST(CommandLine, NamesAnUnknownOptionBeforeWhatIsMissing) {
  expect_untouched({"--bogus"}, "--bogus");
}

TEST(CommandLine, PrintsItsTablesFromTheCaseAlone) {
  const std::string name = ::testing::TempDir() + "tables.toml";
  std::ofstream(name) << "title = \"Wheel\"\n";
  const auto never = [](const StageArguments&) { FAIL() << "the body ran"; };
  EXPECT_EQ(run({name, "--tables"}, never).out, "title = Wheel\n");
  EXPECT_EQ(run({name, "--tables", "--set", "mesh.x=1"}, never).code, 0);
  EXPECT_EQ(run({name, "--tables", "--set", "mash.x=1"}, never).code, 2);
  expect_untouched({"--tables"}, "case.toml is required");
}

/// Control characters of a case reached the terminal, and line breaks broke the line.
TEST(CommandLine, PrintsOthersTextsHarmlessly) {
  const auto complain = [](const StageArguments&) { throw InputError("Gehäuse \x1b[31m\n\x9b: wrong"); };
  EXPECT_EQ(run(inputs, complain).err, "tiprub-tiny: error: Gehäuse \\x1b[31m\\n\\x9b: wrong\n");
  EXPECT_EQ(run(inputs, [](const StageArguments& arguments) { say(arguments, "a\nb\x1b"); }).err, "a\nb\\x1b\n");
  expect_untouched(with({"--fa\nst"}), "--fa\\nst");
}

/// -o case.toml replaced the case.
TEST(CommandLine, RefusesAnOutputThatIsAnInput) {
  const auto never = [](const StageArguments&) { FAIL() << "the body ran"; };
  for (const std::string output : {"b.msh", "./x/../b.msh", "a.toml"}) {
    const Ending ending = run(with({"-o", output}), never);
    EXPECT_EQ(ending.code, 2);
    EXPECT_NE(ending.err.find(output + ": would be written over "), std::string::npos) << ending.err;
  }
}

/// A full disk behind stdout ended with 0.
TEST(CommandLine, FailsIfStdoutCanNotBeWritten) {
  const auto print_to = [](int stream) {
    dup2(stream, STDOUT_FILENO);
    if (stream < 0) close(STDOUT_FILENO);
    std::exit(run(
                  inputs, [](const StageArguments&) { std::printf("data\n"); }, Captured::no)
                  .code);
  };
  EXPECT_EXIT(print_to(open("/dev/full", O_WRONLY)), ::testing::ExitedWithCode(1),
              "^tiprub-tiny: error: stdout: can't be written: No space left on device\n$");
  EXPECT_EXIT(print_to(-1), ::testing::ExitedWithCode(1),
              "^tiprub-tiny: error: stdout: can't be written: Bad file descriptor\n$");
}

TEST(CommandLine, HelpAndVersionGoToStdout) {
  const auto never = [](const StageArguments&) { FAIL() << "the body ran"; };
  const Ending help = run({"--help"}, never), version = run({"--version"}, never);
  EXPECT_EQ(help.code, 0);
  for (const std::string word : {"Does little.", "case.toml", "sector.msh", "tiny.h5", "--check", "--quiet", "--set"})
    EXPECT_NE(help.out.find(word), std::string::npos) << word;
  EXPECT_EQ(version.code, 0);
  EXPECT_EQ(version.out, "tiprub-tiny " TIPRUB_VERSION "\n");
  EXPECT_EQ(version.err, "");
}

TEST(CommandLine, SpeaksOnStderrUnlessQuiet) {
  const auto speak = [](const StageArguments& arguments) { say(arguments, "done"); };
  EXPECT_EQ(run(inputs, speak).err, "done\n");
  EXPECT_EQ(run(inputs, speak).out, "");
  EXPECT_EQ(run(with({"-q"}), speak).err, "");
}

}  // namespace
}  // namespace tiprub::command_line_test
