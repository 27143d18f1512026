// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <filesystem>

namespace tiprub::reduce {

/// A dense matrix that is read column by column, by any number of threads: in memory, or in a file if the memory has
/// to hold other things.
class StoredMatrix {
 public:
  /// In memory.
  explicit StoredMatrix(Eigen::MatrixXd matrix);
  /// In a new file. Raises RunError if it can't be written.
  StoredMatrix(const Eigen::MatrixXd& matrix, std::filesystem::path file);
  StoredMatrix(StoredMatrix&& other) noexcept;
  StoredMatrix& operator=(StoredMatrix&&) = delete;
  ~StoredMatrix();

  Eigen::Index columns() const { return columns_; }
  /// Raises RunError if the file can't be read.
  Eigen::VectorXd column(Eigen::Index k) const;

 private:
  Eigen::MatrixXd matrix_;  ///< empty if it is in the file
  Eigen::Index rows_, columns_;
  std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace tiprub::reduce
