// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/scratch_files.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "cases/program/errors.h"

namespace tiprub::reduce {

namespace {

std::filesystem::path new_folder(const std::filesystem::path& parent) {
  std::string name = (std::filesystem::absolute(parent.empty() ? "." : parent) / ".tiprub-factor-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw RunError(parent.string() +
                   ": no folder for factors can be made: " + std::generic_category().message(errno));
  return name;
}

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

ScratchFolder::ScratchFolder(const std::filesystem::path& parent) : path_(new_folder(parent)) {
  // Reads the name of the folder until this process closes the pipe or ends. It has a session of its own: a signal to
  // the processes of the terminal or of mpirun passes it by.
  constexpr const char* watcher =
      "exec setsid sh -c 'folder=$(cat; echo .); exec rm -rf -- \"${folder%.}\"' >/dev/null 2>&1";
  watcher_ = ::popen(watcher, "we");
  if (watcher_ == nullptr) return;  // the folder then stays if the process is killed
  std::fputs(path_.c_str(), watcher_);
  std::fflush(watcher_);
}

ScratchFolder::~ScratchFolder() {
  if (watcher_ != nullptr) ::pclose(watcher_);
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

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
