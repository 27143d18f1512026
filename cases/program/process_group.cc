// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/process_group.h"

#define OMPI_SKIP_MPICXX 1
#include <mpi.h>

#include <algorithm>
#include <mutex>
#ifdef TIPRUB_SANITIZED
#include <sanitizer/lsan_interface.h>
#endif

namespace tiprub {

namespace {

// Components of MPI lose memory, and are no longer loaded when leaks are looked for: no suppression can name them.
#ifdef TIPRUB_SANITIZED
using LeaksOfOthers = __lsan::ScopedDisabler;
#else
struct LeaksOfOthers {};
#endif

}  // namespace

void start_mpi() {
  [[maybe_unused]] const LeaksOfOthers unchecked{};
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
}

void end_mpi() {
  [[maybe_unused]] const LeaksOfOthers unchecked{};
  MPI_Finalize();
}

struct ProcessGroup::Shared {
  std::mutex one_at_a_time;
  long long counter = 0;  ///< without MPI
  MPI_Win window = MPI_WIN_NULL;
  long long* memory = nullptr;  ///< the leader's counter
};

ProcessGroup::ProcessGroup() : shared_(std::make_unique<Shared>()) {
  if (!started_together()) return;
  start_mpi();
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  MPI_Comm local = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &local);
  MPI_Comm_size(local, &local_size_);
  MPI_Comm_free(&local);
  long long* counter = nullptr;
  MPI_Win_allocate(leads() ? sizeof(long long) : 0, sizeof(long long), MPI_INFO_NULL, MPI_COMM_WORLD, &counter,
                   &shared_->window);
  shared_->memory = counter;
  restart();
}

ProcessGroup::~ProcessGroup() {
  if (shared_->window == MPI_WIN_NULL) return;
  MPI_Win_free(&shared_->window);
  end_mpi();
}

std::size_t ProcessGroup::add(long long increment) {
  const std::lock_guard lock(shared_->one_at_a_time);
  long long before = shared_->counter;
  if (shared_->window == MPI_WIN_NULL) {
    shared_->counter += increment;
  } else {
    MPI_Win_lock(MPI_LOCK_SHARED, 0, 0, shared_->window);
    MPI_Fetch_and_op(&increment, &before, MPI_LONG_LONG, 0, 0, MPI_SUM, shared_->window);
    MPI_Win_unlock(0, shared_->window);
  }
  return static_cast<std::size_t>(before);
}

void ProcessGroup::restart() {
  shared_->counter = 0;
  if (shared_->window == MPI_WIN_NULL) return;
  MPI_Barrier(MPI_COMM_WORLD);
  if (leads()) {
    MPI_Win_lock(MPI_LOCK_EXCLUSIVE, 0, 0, shared_->window);
    *shared_->memory = 0;
    MPI_Win_unlock(0, shared_->window);
  }
  MPI_Barrier(MPI_COMM_WORLD);
}

void ProcessGroup::agree(const std::exception_ptr& failure) {
  if (failed_ && failure) std::rethrow_exception(failure);
  int here = failure ? rank_ : size_, first = here;
  if (shared_->window != MPI_WIN_NULL) MPI_Allreduce(&here, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  failed_ = first < size_;
  if (first == rank_) std::rethrow_exception(failure);
  if (failed_) throw FailedElsewhere();
}

void ProcessGroup::share(std::vector<double>& values) {
  if (shared_->window == MPI_WIN_NULL) return;
  long long count = static_cast<long long>(values.size());
  MPI_Bcast(&count, 1, MPI_LONG_LONG, 0, MPI_COMM_WORLD);
  values.resize(static_cast<std::size_t>(count));
  MPI_Bcast(values.data(), static_cast<int>(count), MPI_DOUBLE, 0, MPI_COMM_WORLD);
}

void ProcessGroup::pass_to_leader(int from, std::vector<double>& values) {
  if (shared_->window == MPI_WIN_NULL || from == 0 || (rank_ != from && !leads())) return;
  constexpr std::size_t at_once = std::size_t{1} << 28;  // MPI counts with 31 bits
  constexpr int tag = 0;
  long long count = static_cast<long long>(values.size());
  if (leads())
    MPI_Recv(&count, 1, MPI_LONG_LONG, from, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  else
    MPI_Send(&count, 1, MPI_LONG_LONG, 0, tag, MPI_COMM_WORLD);
  values.resize(static_cast<std::size_t>(count));
  for (std::size_t first = 0; first < values.size(); first += at_once) {
    const int part = static_cast<int>(std::min(at_once, values.size() - first));
    if (leads())
      MPI_Recv(values.data() + first, part, MPI_DOUBLE, from, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    else
      MPI_Send(values.data() + first, part, MPI_DOUBLE, 0, tag, MPI_COMM_WORLD);
  }
}

}  // namespace tiprub
