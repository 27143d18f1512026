// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <vector>

#include "cases/program/signal_cleanup.h"

namespace tiprub {

/// A file or a folder that appears whole or not at all: it is written beside its place and renamed at the end.
/// Until commit() the old one stands. A run that ends early by an exception removes what it had written; one that
/// ends by SIGINT, SIGTERM or SIGHUP removes its file (a folder only where the stage turns signals into exceptions).
///
/// A folder is replaced only if an OutputFile made all that it holds: commit() leaves the list of its files in it.
class OutputFile {
 public:
  /// Raises RunError if the target's folder doesn't exist, or if what stands at the target may not be replaced: a
  /// folder that holds other people's files, a device.
  explicit OutputFile(std::filesystem::path target);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// Where to write: "sector.tiprub.part.msh" for "sector.msh" (the ending stays, because libraries judge by it).
  const std::filesystem::path& scratch() const { return scratch_; }
  /// Puts what was written in its place, once the disk has all of it. Raises RunError if that can't be done.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path scratch_;
  std::optional<RemovedOnSignal> removed_on_signal_;
};

/// One run at a time on an output: held from before the work until the output stands. A lock of the operating system
/// (flock) on ".NAME.lock" beside the output, so that it ends with the process, however that ends. That file names
/// who holds it. Taking it also shows, before the work, that the output's folder exists and can be written.
class OutputLock {
 public:
  /// Raises RunError if another process holds it, or if its file can't be made.
  explicit OutputLock(const std::filesystem::path& output);
  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;
  ~OutputLock();

 private:
  std::filesystem::path path_;
  int file_ = -1;
  std::optional<RemovedOnSignal> removed_on_signal_;
};

/// A file of whatever `body` puts into the stream, byte for byte; on its place at once. Raises RunError with the
/// system's reason if the file can't be made, or the disk doesn't take all of it.
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& body);

/// Raises InputError if one of the outputs is one of the inputs, by whatever name or link, or another output. Empty
/// names stand for nothing.
void refuse_overwriting(const std::vector<std::filesystem::path>& outputs,
                        const std::vector<std::filesystem::path>& inputs);

}  // namespace tiprub
