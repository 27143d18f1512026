// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/parallel_for.h"

#include <cblas.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tiprub {

void parallel_for(int count, int threads, const std::function<void(int)>& body) {
  const int blas_threads = openblas_get_num_threads();
  openblas_set_num_threads(1);
  std::atomic<int> next = 0;
  std::exception_ptr failure;
  std::mutex failing;
  const auto work = [&] {
    for (int i = next++; i < count; i = next++) try {
        body(i);
      } catch (...) {
        const std::lock_guard lock(failing);
        if (!failure) failure = std::current_exception();
        next = count;
      }
  };
  {
    std::vector<std::jthread> others;
    for (int t = 1; t < std::min(threads, count); ++t) others.emplace_back(work);
    work();
  }
  openblas_set_num_threads(blas_threads);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace tiprub
