// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace tiprub {

/// The input is wrong. The message is one line: where, which value, what is allowed, what to do. Exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A computation failed, or a file can't be read or written. The message is one line. Exit code 1.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file of another stage is damaged, or holds what it cannot hold. Exit code 2, because the input is wrong; a sweep
/// that resumes catches it with the other reasons why a file can't be read.
class FileError : public RunError {
 public:
  using RunError::RunError;
};

}  // namespace tiprub
