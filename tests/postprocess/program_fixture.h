// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "synthetic_scene.h"

namespace tiprub {

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

  static Outcome run(const std::string& arguments, const std::string& environment = "") {
    const std::string command = "cd '" + folder_.string() + "' && " + environment + " " + TIPRUB_POSTPROCESS + " " +
                                arguments + " >out.txt 2>error.txt";
    Outcome outcome;
    const int status = std::system(command.c_str());
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    outcome.out = text_of(folder_ / "out.txt");
    outcome.error = text_of(folder_ / "error.txt");
    return outcome;
  }

  static void write_case(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }

  static void expect_failure(const Outcome& outcome, int exit_code, const std::string& phrase) {
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.error;
    EXPECT_NE(outcome.error.find(phrase), std::string::npos) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "wrong"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "wrong.part"));
  }

  static inline std::filesystem::path folder_;
};

}  // namespace tiprub
