// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>

namespace tiprub::reduce {

/// The BLAS runs on one thread while this lives.
class OneBlasThread {
 public:
  OneBlasThread();
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;
  ~OneBlasThread();

 private:
  int before_;
};

/// Keeps the first exception of tasks that run at once until they are done. Tasks that come after it are skipped.
class FirstException {
 public:
  void guard(const std::function<void()>& task);
  /// Raises the exception again, if there was one.
  void raise() const;

 private:
  std::mutex mutex_;
  std::atomic<bool> raised_ = false;
  std::exception_ptr first_;
};

/// Calls body(0) .. body(count - 1) from up to `threads` threads, each index once. The BLAS runs on one thread
/// meanwhile. Results must not depend on the order. The first exception is raised again here, after all have stopped.
void parallel_for(int count, int threads, const std::function<void(int)>& body);

}  // namespace tiprub::reduce
