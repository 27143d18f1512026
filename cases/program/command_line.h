// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tiprub {

class CaseFile;

enum class Verbosity { quiet, normal, verbose };

/// What to do with the inputs: the work itself, or only a look at whether it could be done.
enum class Action { run, check };

/// How a stage presents itself on the command line.
struct Stage {
  struct Input {
    std::string name;  ///< "case.toml"
    std::string help;
    bool optional = false;  ///< the stage says itself when it is missed
  };
  std::string name;     ///< "tiprub-mesh"
  std::string summary;  ///< one line
  std::vector<Input> inputs;
  std::string output;  ///< default of -o, "sector.msh"
  /// What this stage reads of the case, defaults included, as CaseFile::resolved() gives it; needs nothing but the
  /// case.
  std::function<std::string(const CaseFile&)> tables;
  std::function<void(CLI::App&)> add_options = {};  ///< what only this stage has
};

struct StageArguments {
  std::vector<std::filesystem::path> inputs;
  std::filesystem::path output;
  std::vector<std::string> settings;  ///< "TABLE.KEY=VALUE", over what the case file says
  Verbosity verbosity = Verbosity::normal;
  Action action = Action::run;
};

/// The one `main` of all stages: reads the command line (inputs in chain order, -o, --set, -q, -v, --check, --tables,
/// --times, --version, --help), runs the body, and turns what it throws into one
/// line on stderr. Refuses an -o that is an input. Returns the exit code: 0; 1 for a computation that failed or a
/// file, stdout too, that can't be read or written; 2 for wrong input. SIGINT, SIGTERM and SIGHUP end it with one
/// line and 128 + their number.
int run_stage(int argc, char** argv, const Stage& stage, const std::function<void(const StageArguments&)>& body);

/// "tiprub-mesh 0.1.0", as --version prints it and as files carry it.
std::string program_version(const std::string& program);

/// A line, or more, to stderr, unless quiet.
void say(const StageArguments& arguments, const std::string& text);

/// What OpenBLAS works with, if verbose; a warning, unless quiet, if that is slow.
void say_blas(const StageArguments& arguments);

}  // namespace tiprub
