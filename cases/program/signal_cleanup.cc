// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/signal_cleanup.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstring>
#include <string>

namespace tiprub {

namespace {

// A signal handler reaches nothing but static storage; unlink and _exit are all it may call here.
struct Slot {
  std::array<char, 4096> name{};
  std::atomic<bool> taken{false};
  std::atomic<bool> armed{false};
};
std::array<Slot, RemovedOnSignal::most> slots;

void remove_files_and_leave(int signal_number) {
  constexpr int exit_by_signal = 128;
  for (const Slot& slot : slots)
    if (slot.armed.load()) unlink(slot.name.data());
  _exit(exit_by_signal + signal_number);
}

}  // namespace

RemovedOnSignal::RemovedOnSignal(const std::filesystem::path& file) {
  const std::string name = std::filesystem::absolute(file).string();
  for (int i = 0; i < most && slot_ < 0; ++i)
    if (name.size() < slots[i].name.size() && !slots[i].taken.exchange(true)) slot_ = i;
  if (slot_ < 0) return;
  std::memcpy(slots[slot_].name.data(), name.c_str(), name.size() + 1);
  slots[slot_].armed = true;
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    action.sa_handler = remove_files_and_leave;
    sigaction(number, &action, nullptr);
  }
}

void RemovedOnSignal::release() {
  if (slot_ < 0) return;
  slots[slot_].armed = false;
  slots[slot_].taken = false;
  slot_ = -1;
}

}  // namespace tiprub
