// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/signal_cleanup.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstring>

namespace tiprub {

namespace {

// A signal handler can use static storage only, and may call few functions; unlink, write and _exit are among them.
struct Slot {
  std::array<char, 4096> name{};
  std::atomic<bool> taken{false};
  std::atomic<bool> armed{false};
};
std::array<Slot, RemovedOnSignal::most> slots;
std::array<char, 256> announcement{};

void remove_files_and_leave(int signal_number) {
  constexpr int exit_by_signal = 128;
  for (const Slot& slot : slots)
    if (slot.armed.load()) unlink(slot.name.data());
  tell_interruption();
  _exit(exit_by_signal + signal_number);
}

volatile sig_atomic_t signal_that_came = 0;

void remember(int signal_number) {
  signal_that_came = signal_number;
}

/// Without SA_RESTART: a wait for a child ends at once.
void handle_signals(void (*handler)(int)) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    if (sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) continue;
    action = {};
    action.sa_handler = handler;
    sigaction(number, &action, nullptr);
  }
}

}  // namespace

void announce_signals(const std::string& program) {
  const std::string after_control_c = isatty(STDERR_FILENO) != 0 ? "\n" : "";
  const std::string text =
      after_control_c + program + ": interrupted; what was finished is kept, and no half file is left\n";
  if (text.size() < announcement.size()) std::memcpy(announcement.data(), text.c_str(), text.size() + 1);
  handle_signals(remove_files_and_leave);
}

void tell_interruption() {
  const ssize_t ignored = write(STDERR_FILENO, announcement.data(), std::strlen(announcement.data()));
  static_cast<void>(ignored);
}

RemovedOnSignal::RemovedOnSignal(const std::filesystem::path& file) {
  const std::string name = std::filesystem::absolute(file).string();
  for (int i = 0; i < most && slot_ < 0; ++i)
    if (name.size() < slots[i].name.size() && !slots[i].taken.exchange(true)) slot_ = i;
  if (slot_ < 0) return;
  std::memcpy(slots[slot_].name.data(), name.c_str(), name.size() + 1);
  slots[slot_].armed = true;
  handle_signals(remove_files_and_leave);
}

void RemovedOnSignal::release() {
  if (slot_ < 0) return;
  slots[slot_].armed = false;
  slots[slot_].taken = false;
  slot_ = -1;
}

void note_interruptions() {
  handle_signals(remember);
}

void stop_if_interrupted() {
  if (signal_that_came != 0) throw Interrupted();
}

int interruption() {
  return signal_that_came;
}

}  // namespace tiprub
