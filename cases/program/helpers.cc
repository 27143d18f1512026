// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/helpers.h"

#include <algorithm>

namespace tiprub {

void Helpers::begin() {
  const std::lock_guard lock(mutex_);
  ++busy_;
}

void Helpers::take_part(Offer& offer, std::unique_lock<std::mutex>& lock) {
  const std::size_t i = offer.next++;
  lock.unlock();
  std::exception_ptr failure;
  try {
    (*offer.part)(i);
  } catch (...) {
    failure = std::current_exception();
  }
  lock.lock();
  if (failure && !offer.failure) offer.failure = failure;
  if (++offer.ended == offer.count) changed_.notify_all();
}

void Helpers::share(std::size_t count, const std::function<void(std::size_t)>& part) {
  if (count == 0) return;
  std::unique_lock lock(mutex_);
  const auto offer = offers_.insert(offers_.end(), {&part, count});
  changed_.notify_all();
  while (offer->next < offer->count) take_part(*offer, lock);
  changed_.wait(lock, [&] { return offer->ended == offer->count; });
  const std::exception_ptr failure = offer->failure;
  offers_.erase(offer);
  lock.unlock();
  if (failure) std::rethrow_exception(failure);
}

void Helpers::help() {
  std::unique_lock lock(mutex_);
  --busy_;
  changed_.notify_all();
  for (;;) {
    const auto open = std::ranges::find_if(offers_, [](const Offer& offer) { return offer.next < offer.count; });
    if (open != offers_.end())
      take_part(*open, lock);
    else if (busy_ == 0)
      return;
    else
      changed_.wait(lock);
  }
}

void share(Helpers* helpers, std::size_t count, const std::function<void(std::size_t)>& part) {
  if (helpers != nullptr) return helpers->share(count, part);
  for (std::size_t i = 0; i < count; ++i) part(i);
}

}  // namespace tiprub
