// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <filesystem>

namespace tiprub::reduce {

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
