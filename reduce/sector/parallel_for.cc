// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/parallel_for.h"

#include <cblas.h>

#include "cases/program/machine.h"

namespace tiprub::reduce {

OneBlasThread::OneBlasThread() : before_(openblas_get_num_threads()) {
  openblas_set_num_threads(1);
}

OneBlasThread::~OneBlasThread() {
  openblas_set_num_threads(before_);
}

void FirstException::guard(const std::function<void()>& task) {
  if (raised_) return;
  try {
    task();
  } catch (...) {
    const std::lock_guard lock(mutex_);
    if (!raised_.exchange(true)) first_ = std::current_exception();
  }
}

void FirstException::raise() const {
  if (first_) std::rethrow_exception(first_);
}

void parallel_for(int count, int threads, const std::function<void(int)>& body) {
  const OneBlasThread one_each;
  work_on_pieces(count, 1, threads, [&](std::ptrdiff_t i, std::ptrdiff_t) { body(static_cast<int>(i)); });
}

}  // namespace tiprub::reduce
