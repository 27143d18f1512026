// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/stored_matrix.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "cases/program/errors.h"

namespace tiprub::reduce {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw RunError(path.string() + ": can't be written: " + std::generic_category().message(error));
}

/// Maps a new file of some size, all of it zeros, which has its room on the disk.
double* map_new_file(const std::filesystem::path& path, std::size_t bytes) {
  const int file = ::open(path.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0600);
  if (file < 0) fail(path, errno);
  // A write to a mapped page for which the disk has no room would end the process.
  int error = ::posix_fallocate(file, 0, static_cast<off_t>(bytes));
  void* const mapped = error == 0 ? ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0) : MAP_FAILED;
  if (error == 0 && mapped == MAP_FAILED) error = errno;
  ::close(file);
  if (error != 0) fail(path, error);
  return static_cast<double*>(mapped);
}

}  // namespace

StoredMatrix::StoredMatrix(Eigen::MatrixXd matrix)
    : memory_(std::move(matrix)), values_(memory_.data(), memory_.rows(), memory_.cols()) {}

StoredMatrix::StoredMatrix(Eigen::Index rows, Eigen::Index columns, const std::filesystem::path& file)
    : mapped_bytes_(sizeof(double) * static_cast<std::size_t>(rows * columns)),
      values_(map_new_file(file, mapped_bytes_), rows, columns) {}

StoredMatrix::StoredMatrix(StoredMatrix&& other) noexcept
    : memory_(std::move(other.memory_)),
      mapped_bytes_(std::exchange(other.mapped_bytes_, 0)),
      values_(other.values_.data(), other.values_.rows(), other.values_.cols()) {}

StoredMatrix::~StoredMatrix() {
  if (mapped_bytes_ > 0) ::munmap(values_.data(), mapped_bytes_);
}

}  // namespace tiprub::reduce
