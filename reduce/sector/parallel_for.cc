// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/parallel_for.h"

#include <cblas.h>

#include <algorithm>
#include <atomic>

#include "cases/program/machine.h"

namespace tiprub {

namespace {

/// The BLAS runs on one thread while this lives.
class OneBlasThread {
 public:
  OneBlasThread() { openblas_set_num_threads(1); }
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;
  ~OneBlasThread() { openblas_set_num_threads(before_); }

 private:
  int before_ = openblas_get_num_threads();
};

}  // namespace

void parallel_for(int count, int threads, const std::function<void(int)>& body) {
  const OneBlasThread one_each;
  std::atomic<int> next = 0;
  work_together(std::min(threads, count), [&] {
    for (int i = next++; i < count; i = next++) try {
        body(i);
      } catch (...) {
        next = count;  // the others need not go on
        throw;
      }
  });
}

}  // namespace tiprub
