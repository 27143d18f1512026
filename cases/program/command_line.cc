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
#include <optional>

#include "cases/program/case_file.h"
#include "cases/program/errors.h"
#include "cases/program/machine.h"
#include "cases/program/output_file.h"
#include "cases/program/process_group.h"
#include "cases/program/signal_cleanup.h"
#include "cases/program/text.h"

namespace tiprub {

namespace {

constexpr int exit_failed = 1;
constexpr int exit_wrong_input = 2;

int complain(const Stage& stage, const std::string& message, int exit_code) {
  constexpr std::size_t longest = 2000;  // bytes: a message may quote what a file holds
  std::fprintf(stderr, "%s: error: %s\n", stage.name.c_str(), shortened(printable(message), longest).c_str());
  return exit_code;
}

/// A closed stream would give its number to the next file that is opened, and that file would receive what is
/// printed. Writing to this stand-in of stdout fails.
void hold_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0) open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
}

/// The exit code, once stdout has been written to its end.
int leave(const Stage& stage, int exit_code) {
  errno = 0;
  std::cout.flush();
  const bool whole = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
  if (whole || exit_code != 0) return exit_code;
  const std::string reason = errno != 0 ? std::string(": ") + std::strerror(errno) : "";
  return complain(stage, "stdout: can't be written" + reason, exit_failed);
}

/// [s] of user and system time.
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

using Clock = std::chrono::steady_clock;

/// Notes how long a program ran as one row of CSV: wall time, processor time (with that of the programs it started)
/// and the processors that it could use. Under MPI these are the numbers of the first process. Raises RunError.
void write_times(OutputFile& output, const std::string& program, Clock::time_point begin) {
  const double wall = std::chrono::duration<double>(Clock::now() - begin).count();
  write_file(output.scratch(), [&](std::ostream& stream) {
    stream << "program,wall time [s],processor time [s],processors\n"
           << program << ',' << wall << ',' << processor_time(RUSAGE_SELF) + processor_time(RUSAGE_CHILDREN) << ','
           << processors() << '\n';
  });
  output.commit();
}

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
    app.add_option("-o,--output", arguments.output, "the output")->capture_default_str();
    app.add_option("--set", arguments.settings,
                   "TABLE.KEY=VALUE replaces a key of the case file, TABLE.KEY= removes it; may be repeated")
        ->allow_extra_args(false);
    app.add_option("--times", times, "write the time of the run to this file, for tiprub-postprocess --runs");
    app.add_flag("--check", check, "validate the inputs and stop");
    app.add_flag("--tables", tables, "print all keys that are read from the case, and stop; requires no other input");
    CLI::Option* quiet_flag = app.add_flag("-q,--quiet", quiet, "print only results and errors");
    app.add_flag("-v,--verbose", verbose, "print every parameter and choice")->excludes(quiet_flag);
    if (stage.add_options) stage.add_options(app);
  }

  /// Raises CLI::ParseError. Missing inputs are reported last, so that a misspelt option is reported first.
  void parse(const Stage& stage, int argc, char** argv) {
    app.parse(argc, argv);
    for (std::size_t i = 0; i < (tables ? 1 : stage.inputs.size()); ++i)
      if (arguments.inputs[i].empty() && !stage.inputs[i].optional) throw CLI::RequiredError(stage.inputs[i].name);
    if (check) arguments.action = Action::check;
    if (quiet) arguments.verbosity = Verbosity::quiet;
    if (verbose) arguments.verbosity = Verbosity::verbose;
  }
};

/// Runs the body, and turns what it throws into an exit code.
int run(const Stage& stage, const std::function<void()>& body) {
  try {
    body();
    return 0;
  } catch (const FailedElsewhere&) {
    return exit_failed;
  } catch (const InputError& error) {
    return complain(stage, error.what(), exit_wrong_input);
  } catch (const FileError& error) {
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
  const Clock::time_point begin = Clock::now();
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
    std::optional<OutputFile> times;
    if (!line.times.empty() && !line.check && started_first()) times.emplace(line.times);
    body(arguments);
    if (times) write_times(*times, program_version(stage.name), begin);
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
