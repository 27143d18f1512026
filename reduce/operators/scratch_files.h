// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstddef>
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

/// A large dense matrix: in memory, or mapped from a file if the memory has to hold other things.
class StoredMatrix {
 public:
  /// In memory.
  explicit StoredMatrix(Eigen::MatrixXd matrix);
  /// Zeros in a new file. Raises RunError if it can't be made, or if the disk has no room for it.
  StoredMatrix(Eigen::Index rows, Eigen::Index columns, const std::filesystem::path& file);
  StoredMatrix(StoredMatrix&& other) noexcept;
  StoredMatrix& operator=(StoredMatrix&&) = delete;
  ~StoredMatrix();

  Eigen::Map<Eigen::MatrixXd>& values() { return values_; }
  const Eigen::Map<Eigen::MatrixXd>& values() const { return values_; }

 private:
  Eigen::MatrixXd memory_;        ///< empty if the matrix is in a file
  std::size_t mapped_bytes_ = 0;  ///< of the file
  Eigen::Map<Eigen::MatrixXd> values_;
};

}  // namespace tiprub::reduce
