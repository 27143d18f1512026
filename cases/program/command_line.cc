// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/command_line.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>

#include "cases/program/case_file.h"
#include "cases/program/errors.h"
#include "cases/program/machine.h"
#include "cases/program/output_file.h"
#include "cases/program/printable.h"
#include "cases/program/signal_cleanup.h"

namespace tiprub {

namespace {

constexpr int exit_failed = 1;
constexpr int exit_wrong_input = 2;

int complain(const Stage& stage, const std::string& message, int exit_code) {
  std::fprintf(stderr, "%s: error: %s\n", stage.name.c_str(), printable(message).c_str());
  return exit_code;
}

/// A stream that is closed gives its number to the next file that is opened, and what is printed goes into that one.
/// Writing to this stand-in of stdout fails.
void hold_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0) open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
}

/// The exit code, after all of stdout has gone out.
int leave(const Stage& stage, int exit_code) {
  errno = 0;
  std::cout.flush();
  const bool whole = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
  if (whole || exit_code != 0) return exit_code;
  return complain(
      stage,
      std::string("stdout: can't be written") + (errno != 0 ? ": " : "") + (errno != 0 ? std::strerror(errno) : ""),
      exit_failed);
}

/// [s] of the user's and the system's work.
double processor_time(int whose) {
  constexpr double microsecond = 1e-6;
  rusage used{};
  getrusage(whose, &used);
  return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
         microsecond * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

int processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

/// How long a program ran, noted for people: one row of CSV, "program", "wall time [s]", "processor time [s]" (its
/// own and that of what it started) and "processors" (that it might run on). Under MPI they are one process's.
class RunTimes {
 public:
  /// Writes the note. Raises RunError if the file can't be written.
  void write(const std::string& program, const std::filesystem::path& path) const;

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

void RunTimes::write(const std::string& program, const std::filesystem::path& path) const {
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  OutputFile output(path);
  write_file(output.scratch(), [&](std::ostream& stream) {
    stream << "program,wall time [s],processor time [s],processors\n"
           << program << ',' << wall << ',' << processor_time(RUSAGE_SELF) + processor_time(RUSAGE_CHILDREN) << ','
           << processors() << '\n';
  });
  output.commit();
}

/// What the command line says.
struct CommandLine {
  CLI::App app;
  StageArguments arguments;
  std::filesystem::path times;  ///< empty: not noted
  bool check = false, tables = false, quiet = false, verbose = false;

  explicit CommandLine(const Stage& stage) : app(stage.summary, stage.name) {
    app.set_version_flag("--version", program_version(stage.name));
    arguments.inputs.resize(stage.inputs.size());
    arguments.output = stage.output;
    for (std::size_t i = 0; i < stage.inputs.size(); ++i)
      app.add_option(stage.inputs[i].name, arguments.inputs[i], stage.inputs[i].help);
    app.add_option("-o,--output", arguments.output, "what to write")->capture_default_str();
    app.add_option("--set", arguments.settings,
                   "a key of the case file instead of its own, TABLE.KEY=VALUE; may be repeated")
        ->allow_extra_args(false);
    app.add_option("--times", times, "a file to note in how long the run took; tiprub-postprocess --runs shows it");
    app.add_flag("--check", check, "validate the inputs and stop");
    app.add_flag("--tables", tables,
                 "print what is read of the case, which is all the input that this needs, and stop");
    CLI::Option* quiet_flag = app.add_flag("-q,--quiet", quiet, "print nothing but errors");
    app.add_flag("-v,--verbose", verbose, "print every parameter and choice")->excludes(quiet_flag);
    if (stage.add_options) stage.add_options(app);
  }

  /// Raises CLI::ParseError. Inputs are missed last: a misspelt option is told first.
  void parse(const Stage& stage, int argc, char** argv) {
    app.parse(argc, argv);
    for (std::size_t i = 0; i < (tables ? 1 : stage.inputs.size()); ++i)
      if (arguments.inputs[i].empty() && !stage.inputs[i].optional) throw CLI::RequiredError(stage.inputs[i].name);
    if (check) arguments.action = Action::check;
    if (quiet) arguments.verbosity = Verbosity::quiet;
    if (verbose) arguments.verbosity = Verbosity::verbose;
  }
};

/// The body's part of it: exceptions to exit codes.
int run(const Stage& stage, const std::function<void()>& body) {
  try {
    body();
    return 0;
  } catch (const InputError& error) {
    return complain(stage, error.what(), exit_wrong_input);
  } catch (const std::bad_alloc&) {
    return complain(stage, "not enough memory", exit_failed);
  } catch (const std::filesystem::filesystem_error& error) {
    return complain(stage, error.path1().string() + ": " + error.code().message(), exit_failed);
  } catch (const std::exception& error) {
    return complain(stage, error.what(), exit_failed);
  }
}

int parse_and_run(int argc, char** argv, const Stage& stage, const std::function<void(const StageArguments&)>& body) {
  const RunTimes times;
  CommandLine line(stage);
  try {
    line.parse(stage, argc, argv);
  } catch (const CLI::Success& success) {
    return line.app.exit(success);
  } catch (const CLI::ParseError& error) {
    return complain(stage, std::string(error.what()) + "; see " + stage.name + " --help", exit_wrong_input);
  }
  const StageArguments& arguments = line.arguments;
  return run(stage, [&] {
    if (line.tables) {
      std::cout << stage.tables(CaseFile(arguments.inputs[0], arguments.settings));
      return;
    }
    require_room_for_libraries();
    refuse_overwriting({arguments.output, line.times}, arguments.inputs);
    body(arguments);
    if (!line.times.empty() && !line.check) times.write(program_version(stage.name), line.times);
  });
}

}  // namespace

int run_stage(int argc, char** argv, const Stage& stage, const std::function<void(const StageArguments&)>& body) {
  hold_closed_streams();
  announce_signals(stage.name);
  return leave(stage, parse_and_run(argc, argv, stage, body));
}

std::string program_version(const std::string& program) {
  return program + " " + TIPRUB_VERSION;
}

void say(const StageArguments& arguments, const std::string& text) {
  if (arguments.verbosity != Verbosity::quiet)
    std::fprintf(stderr, "%s\n", printable(text, LineBreaks::kept).c_str());
}

void say_blas(const StageArguments& arguments) {
  const std::string description = blas_description(), warning = blas_warning();
  if (arguments.verbosity == Verbosity::verbose && !description.empty()) say(arguments, "BLAS: " + description);
  if (!warning.empty()) say(arguments, "warning: " + warning);
}

}  // namespace tiprub
