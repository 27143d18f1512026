// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <memory>
#include <vector>

namespace tiprub {

/// Whether mpirun or srun started this process, as the environment variables of Open MPI, of MPICH and Intel MPI, and
/// of Slurm's PMIx tell.
inline bool started_together() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"})
    if (std::getenv(name) != nullptr) return true;
  return false;
}

/// Whether this process is the first of those, or the only one, by variables of the same programs.
inline bool started_first() {
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK"})
    if (const char* rank = std::getenv(name)) return std::atoi(rank) == 0;
  return true;
}

/// Starts MPI, for one call of it at a time; and ends it.
void start_mpi();
void end_mpi();

/// Raised in the processes of a group other than the one that failed and says why. The program then ends without a
/// message of its own.
struct FailedElsewhere : std::exception {
  const char* what() const noexcept override { return "another process failed"; }
};

/// The processes that share the work of a program: those that mpirun started together, or only this one. MPI is
/// initialised only under mpirun, which is recognised by environment variables; the serial program starts without it.
/// A program may hold one group at most, because its destructor finalises MPI.
class ProcessGroup {
 public:
  ProcessGroup();
  ProcessGroup(const ProcessGroup&) = delete;
  ProcessGroup& operator=(const ProcessGroup&) = delete;
  ~ProcessGroup();

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool leads() const { return rank_ == 0; }
  /// Processes of the group on this machine.
  int local_size() const { return local_size_; }

  /// Returns 0, 1, 2, ...: each number goes to one caller only, in any thread of any process. It is one atomic
  /// addition in the memory of the leader; no process waits for another.
  std::size_t next() { return add(1); }
  /// Lets next() start again at 0. All processes must call it after the last number of a list has been taken.
  void restart();
  /// From now on next() gives numbers beyond any list.
  void stop() { add(beyond_any_list); }
  /// Waits for all processes, which must all call it. If some have failed, raises the failure of the first of them
  /// there and FailedElsewhere in the others, which would otherwise wait for ever. After that it waits no more.
  void agree(const std::exception_ptr& failure);
  /// Runs work that may fail in one process only, and agrees.
  template <class Body>
  void together(const Body& body) {
    std::exception_ptr failure;
    try {
      body();
    } catch (...) {
      failure = std::current_exception();
    }
    agree(failure);
  }
  /// Gives the values of the leader to all processes, which must all call it.
  void share(std::vector<double>& values);
  /// Gives the values of one process to the leader, in its vector. Both must call it; for others nothing happens.
  void pass_to_leader(int from, std::vector<double>& values);

 private:
  struct Shared;
  static constexpr long long beyond_any_list = 1LL << 40;

  std::size_t add(long long increment);

  int rank_ = 0, size_ = 1, local_size_ = 1;
  bool failed_ = false;
  std::unique_ptr<Shared> shared_;
};

}  // namespace tiprub
