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

/// Whether the stage does its work, or only checks that it could.
enum class Action { run, check };

/// How a stage presents itself on the command line.
struct Stage {
  struct Input {
    std::string name;  ///< "case.toml"
    std::string help;
    bool optional = false;  ///< the stage itself refuses if it is missing and needed
  };
  std::string name;     ///< "tiprub-mesh"
  std::string summary;  ///< one line
  std::vector<Input> inputs;
  std::string output;  ///< default of -o, "sector.msh"
  /// What this stage reads of the case, defaults included, as CaseFile::resolved() gives it.
  std::function<std::string(const CaseFile&)> tables;
  std::function<void(CLI::App&)> add_options = {};  ///< options of this stage only
};

struct StageArguments {
  std::vector<std::filesystem::path> inputs;
  std::filesystem::path output;
  std::vector<std::string> settings;  ///< "TABLE.KEY=VALUE", in place of what the case file says
  Verbosity verbosity = Verbosity::normal;
  Action action = Action::run;
};

/// The `main` of all stages. It reads the command line (inputs in chain order, -o, --set, -q, -v, --check, --tables,
/// --times, --version, --help), refuses an -o that is an input, runs the body, and turns what that throws into one
/// line on stderr. The exit code is 0; 1 if a computation failed, or if a file or stdout can't be read or written; 2
/// if an input is wrong. SIGINT, SIGTERM and SIGHUP end the program with one line and 128 + their number.
int run_stage(int argc, char** argv, const Stage& stage, const std::function<void(const StageArguments&)>& body);

/// "tiprub-mesh 0.1.0", which --version prints and output files hold.
std::string program_version(const std::string& program);

/// Prints one or more lines on stderr, unless quiet.
void say(const StageArguments& arguments, const std::string& text);

/// Tells, if verbose, which kernels OpenBLAS uses, and warns, unless quiet, if these are slow.
void say_blas(const StageArguments& arguments);

}  // namespace tiprub
