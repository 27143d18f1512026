// SPDX-License-Identifier: GPL-3.0-or-later
// A group of one process, for builds without MPI (TIPRUB_MPI=OFF).
#include <atomic>

#include "cases/program/errors.h"
#include "cases/program/process_group.h"

namespace tiprub {

struct ProcessGroup::Shared {
  std::atomic<long long> counter = 0;
};

ProcessGroup::ProcessGroup() : shared_(std::make_unique<Shared>()) {
  if (started_together())
    throw RunError(
        "mpirun started this program, which was built without MPI (TIPRUB_MPI=OFF), so that each process would do "
        "all the work; start it without mpirun, and share the speeds with --threads");
}

ProcessGroup::~ProcessGroup() = default;

std::size_t ProcessGroup::add(long long increment) {
  return static_cast<std::size_t>(shared_->counter.fetch_add(increment));
}

void ProcessGroup::restart() {
  shared_->counter = 0;
}

void ProcessGroup::agree(const std::exception_ptr& failure) {
  if (failure) std::rethrow_exception(failure);
}

void ProcessGroup::share(std::vector<double>&) {}

void ProcessGroup::pass_to_leader(int, std::vector<double>&) {}

}  // namespace tiprub
