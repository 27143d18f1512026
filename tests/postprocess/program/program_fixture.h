// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "synthetic_scene.h"

namespace tiprub::postprocess {

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

struct Outcome {
  int exit_code = -1;
  std::string out, error;
};

/// The executable in a folder with a made scene; the folder goes when the suite ends.
class Program : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::filesystem::temp_directory_path() / ("tiprub-postprocess-" + std::to_string(getpid()));
    synthetic::write_scene(folder_);
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(folder_); }

  /// `environment`: variables of the shell, "NAME=value ".
  static Outcome run(const std::string& arguments, const std::string& environment = "") {
    const std::string command = "cd '" + folder_.string() + "' && " + environment + TIPRUB_POSTPROCESS + " " +
                                arguments + " >out.txt 2>error.txt";
    Outcome outcome;
    const int status = std::system(command.c_str());
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    outcome.out = text_of(folder_ / "out.txt");
    outcome.error = text_of(folder_ / "error.txt");
    return outcome;
  }

  static inline std::filesystem::path folder_;
};

}  // namespace tiprub::postprocess
