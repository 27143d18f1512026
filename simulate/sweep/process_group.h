// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <exception>
#include <memory>
#include <vector>

namespace tiprub {

/// The processes that share a sweep: those that mpirun started together, or this one alone. MPI is initialised only
/// under mpirun (by what it leaves in the environment): the serial program starts without it. At most one may live in
/// a program; its end is MPI's end.
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

  /// 0, 1, 2, ...: each number goes to one caller only, in any process. Any thread may ask. One atomic addition in
  /// the leader's memory; no process waits for another one.
  std::size_t next();
  /// next() begins anew; all processes must call, after the last one of a list has been taken.
  void restart();
  /// From now on next() gives numbers beyond any list.
  void stop();
  /// Waits for all processes, and raises in all if one failed: its failure there, RunError in the others. An
  /// exception that only one of them saw would leave the others waiting. All must call.
  void agree(const std::exception_ptr& failure);
  /// Does what may fail in one process alone, and agrees.
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
  /// The leader's values for all; all processes must call.
  void share(std::vector<double>& values);

 private:
  struct Shared;
  std::size_t add(long long increment);

  int rank_ = 0, size_ = 1, local_size_ = 1;
  std::unique_ptr<Shared> shared_;
};

}  // namespace tiprub
