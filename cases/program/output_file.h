// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace tiprub {

/// A file or a folder that appears whole or not at all: it is written beside its place and renamed at the end.
/// Until commit() the old one stands. A run that ends early by an exception removes what it had written; one that
/// ends by SIGINT, SIGTERM or SIGHUP removes its file. A signal handler may not remove a folder: a stage that writes
/// one turns signals into exceptions. At most one OutputFile may live at a time in a program.
class OutputFile {
 public:
  /// Raises RunError if the target's folder doesn't exist.
  explicit OutputFile(std::filesystem::path target);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// Where to write: "sector.part.msh" for "sector.msh" (the ending stays, because libraries judge by it).
  const std::filesystem::path& scratch() const { return scratch_; }
  /// Puts what was written in its place. Raises RunError if that can't be done.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path scratch_;
};

}  // namespace tiprub
