// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <list>
#include <mutex>

namespace tiprub {

/// Threads that have finished their own work and help those that have not. Each calls begin() before its work and
/// help() after it; in between it may share() the parts of a long piece of work.
class Helpers {
 public:
  Helpers() = default;
  Helpers(const Helpers&) = delete;
  Helpers& operator=(const Helpers&) = delete;

  void begin();

  /// Calls part(0) to part(count - 1), each once, on this thread and on those that help, and returns after all of
  /// them. Results must not depend on the order or on the threads. If parts raise exceptions, one is raised again.
  void share(std::size_t count, const std::function<void(std::size_t)>& part);

  /// Takes parts that other threads share, until all that began help. Raises nothing.
  void help();

 private:
  struct Offer {
    const std::function<void(std::size_t)>* part;
    std::size_t count, next = 0, ended = 0;
    std::exception_ptr failure = nullptr;
  };
  void take_part(Offer& offer, std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::list<Offer> offers_;
  int busy_ = 0;
};

/// As Helpers::share(), or on this thread alone if there are no helpers (nullptr).
void share(Helpers* helpers, std::size_t count, const std::function<void(std::size_t)>& part);

}  // namespace tiprub
