// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/command_line.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

#include "cases/program/errors.h"

namespace tiprub {

namespace {

constexpr int exit_failed = 1;
constexpr int exit_wrong_input = 2;

int complain(const Stage& stage, const std::string& message, int exit_code) {
  std::fprintf(stderr, "%s: error: %s\n", stage.name.c_str(), message.c_str());
  return exit_code;
}

}  // namespace

int run_stage(int argc, char** argv, const Stage& stage, const std::function<void(const StageArguments&)>& body) {
  CLI::App app(stage.summary, stage.name);
  app.set_version_flag("--version", program_version(stage.name));
  StageArguments arguments;
  arguments.inputs.resize(stage.inputs.size());
  arguments.output = stage.output;
  for (std::size_t i = 0; i < stage.inputs.size(); ++i)
    app.add_option(stage.inputs[i].name, arguments.inputs[i], stage.inputs[i].help)->required();
  app.add_option("-o,--output", arguments.output, "what to write")->capture_default_str();
  app.add_option("--set", arguments.settings,
                 "a key of the case file instead of its own, TABLE.KEY=VALUE; may be repeated")
      ->allow_extra_args(false);
  bool check = false, quiet = false, verbose = false;
  app.add_flag("--check", check, "validate the inputs and stop");
  CLI::Option* quiet_flag = app.add_flag("-q,--quiet", quiet, "print nothing but errors");
  app.add_flag("-v,--verbose", verbose, "print every parameter and choice")->excludes(quiet_flag);
  if (stage.add_options) stage.add_options(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return complain(stage, std::string(error.what()) + "; see " + stage.name + " --help", exit_wrong_input);
  }
  if (check) arguments.action = Action::check;
  if (quiet) arguments.verbosity = Verbosity::quiet;
  if (verbose) arguments.verbosity = Verbosity::verbose;
  try {
    body(arguments);
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

std::string program_version(const std::string& program) {
  return program + " " + TIPRUB_VERSION;
}

void say(const StageArguments& arguments, const std::string& line) {
  if (arguments.verbosity != Verbosity::quiet) std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace tiprub
