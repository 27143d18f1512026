// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <filesystem>

namespace tiprub::reduce {

/// A new folder for files that may be larger than the memory. It is removed with this object, and also if the
/// process ends in any other way, killed or for lack of memory: a shell that waits for the process's end removes it
/// then.
class ScratchFolder {
 public:
  /// Raises RunError if no folder can be made in `parent`.
  explicit ScratchFolder(const std::filesystem::path& parent);
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::FILE* watcher_ = nullptr;  ///< a pipe to the shell
};

}  // namespace tiprub::reduce
