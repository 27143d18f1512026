// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <vector>

#include "cases/program/signal_cleanup.h"

namespace tiprub {

/// A file or a folder that appears whole or not at all: it is written beside its place and renamed by commit(). Until
/// then the old one stays. If an exception ends the run, what was written is removed. So is a file if SIGINT, SIGTERM
/// or SIGHUP ends it; a stage that writes a folder must turn these signals into exceptions.
///
/// A folder is replaced only if an OutputFile made all files in it. For this, commit() leaves a list of them there.
class OutputFile {
 public:
  enum class Kind { file, folder };

  /// Raises RunError if the folder of the target doesn't exist, or if the target may not be replaced: it is of
  /// another kind, a device, or a folder with files that this program did not make.
  explicit OutputFile(const std::filesystem::path& target, Kind kind = Kind::file);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// Where to write: "sector.tiprub.part.msh" for "sector.msh". The extension stays, because libraries look at it.
  const std::filesystem::path& scratch() const { return scratch_; }
  /// Moves what was written to its place, once the disk has all of it. Raises RunError if that fails.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path scratch_;
  Kind kind_;
  std::optional<RemovedOnSignal> removed_on_signal_;
};

/// Lets one run at a time work on an output. It is a lock of the operating system (flock) on ".NAME.lock" beside the
/// output, so that it ends with the process in any case. The file names the process. Taking the lock also shows,
/// before the work, that the folder of the output exists and can be written.
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

/// Writes what `body` puts into the stream, byte for byte, directly to its place. Raises RunError with the reason of
/// the system if the file can't be made, or the disk doesn't take all of it.
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& body);

/// Raises InputError if an output is the same file as an input or as another output, also by another name or by a
/// link. Empty names are left out.
void refuse_overwriting(const std::vector<std::filesystem::path>& outputs,
                        const std::vector<std::filesystem::path>& inputs);

}  // namespace tiprub
