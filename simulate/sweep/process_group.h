// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <exception>
#include <memory>
#include <vector>

namespace tiprub::simulate {

/// The processes that share a sweep: those that mpirun started together, or only this one. MPI is initialised only
/// under mpirun, which is recognised by environment variables; the serial program starts without it. A program may
/// hold one group at most, because its destructor finalises MPI.
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
  std::size_t next();
  /// Lets next() start again at 0. All processes must call it after the last number of a list has been taken.
  void restart();
  /// From now on next() gives numbers beyond any list.
  void stop();
  /// Waits for all processes, which must all call it. If one has failed, raises its failure there and RunError in the
  /// others, which would otherwise wait for ever.
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

 private:
  struct Shared;
  std::size_t add(long long increment);

  int rank_ = 0, size_ = 1, local_size_ = 1;
  std::unique_ptr<Shared> shared_;
};

}  // namespace tiprub::simulate
