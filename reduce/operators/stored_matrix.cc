// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/stored_matrix.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "cases/program/errors.h"

namespace tiprub::reduce {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* what) {
  throw RunError(path.string() + ": can't be " + what + ": " + std::generic_category().message(errno));
}

}  // namespace

StoredMatrix::StoredMatrix(Eigen::MatrixXd matrix)
    : matrix_(std::move(matrix)), rows_(matrix_.rows()), columns_(matrix_.cols()) {}

StoredMatrix::StoredMatrix(const Eigen::MatrixXd& matrix, std::filesystem::path file)
    : rows_(matrix.rows()),
      columns_(matrix.cols()),
      path_(std::move(file)),
      file_(::open(path_.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0600)) {
  const auto* next = reinterpret_cast<const char*>(matrix.data());
  for (std::size_t left = sizeof(double) * static_cast<std::size_t>(matrix.size()); file_ >= 0 && left > 0;) {
    const ssize_t written = ::write(file_, next, left);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      ::close(file_);
      file_ = -1;
      break;
    }
    next += written;
    left -= static_cast<std::size_t>(written);
  }
  if (file_ < 0) fail(path_, "written");
}

StoredMatrix::StoredMatrix(StoredMatrix&& other) noexcept
    : matrix_(std::move(other.matrix_)),
      rows_(other.rows_),
      columns_(other.columns_),
      path_(std::move(other.path_)),
      file_(std::exchange(other.file_, -1)) {}

StoredMatrix::~StoredMatrix() {
  if (file_ >= 0) ::close(file_);
}

Eigen::VectorXd StoredMatrix::column(Eigen::Index k) const {
  if (file_ < 0) return matrix_.col(k);
  Eigen::VectorXd values(rows_);
  const std::size_t bytes = sizeof(double) * static_cast<std::size_t>(rows_);
  auto* const begin = reinterpret_cast<char*>(values.data());
  for (std::size_t done = 0; done < bytes;) {
    const ssize_t got = ::pread(file_, begin + done, bytes - done,
                                static_cast<off_t>(bytes) * static_cast<off_t>(k) + static_cast<off_t>(done));
    if (got < 0 && errno == EINTR) continue;
    if (got == 0) errno = EIO;
    if (got <= 0) fail(path_, "read");
    done += static_cast<std::size_t>(got);
  }
  return values;
}

}  // namespace tiprub::reduce
