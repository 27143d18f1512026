// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/output_file.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstring>

#include "cases/program/errors.h"

namespace fs = std::filesystem;

namespace tiprub {

namespace {

// A signal handler reaches nothing but static storage; unlink and _exit are all it may call here.
std::array<char, 4096> scratch_name{};
std::atomic<bool> scratch_exists{false};

void remove_scratch_and_leave(int signal_number) {
  if (scratch_exists.load()) unlink(scratch_name.data());
  _exit(128 + signal_number);
}

void watch(const fs::path& scratch) {
  const std::string name = fs::absolute(scratch).string();
  if (name.size() >= scratch_name.size()) return;
  std::memcpy(scratch_name.data(), name.c_str(), name.size() + 1);
  scratch_exists = true;
  for (int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    action.sa_handler = remove_scratch_and_leave;
    sigaction(number, &action, nullptr);
  }
}

}  // namespace

OutputFile::OutputFile(fs::path target) : target_(std::move(target)) {
  scratch_ = target_;
  if (!scratch_.has_filename()) scratch_ = scratch_.parent_path();  // "report/" is the folder "report"
  target_ = scratch_;
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  if (!fs::is_directory(folder))
    throw RunError(target_.string() + ": can't be written: no folder " + folder.string());
  scratch_.replace_filename(target_.stem().string() + ".part" + target_.extension().string());
  fs::remove_all(scratch_);
  watch(scratch_);
}

OutputFile::~OutputFile() {
  scratch_exists = false;
  std::error_code ignored;
  fs::remove_all(scratch_, ignored);
}

void OutputFile::commit() {
  std::error_code error;
  if (fs::is_directory(scratch_) && fs::exists(target_)) {  // rename() replaces files, but only empty folders
    fs::path old = target_;
    old += ".old";
    fs::remove_all(old, error);
    fs::rename(target_, old, error);
    if (!error) fs::rename(scratch_, target_, error);
    if (!error) fs::remove_all(old, error);
  } else {
    fs::rename(scratch_, target_, error);
  }
  scratch_exists = false;
  if (error) throw RunError(target_.string() + ": can't be written: " + error.message());
}

}  // namespace tiprub
