// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/tables/interruption.h"

#include <signal.h>

#include <initializer_list>

namespace tiprub {

namespace {

volatile sig_atomic_t signal_that_came = 0;

void note(int signal_number) {
  signal_that_came = signal_number;
}

}  // namespace

void note_interruptions() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    if (sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) continue;  // nohup
    action = {};
    action.sa_handler = note;  // no SA_RESTART: a wait for a child ends at once
    sigaction(number, &action, nullptr);
  }
}

void stop_if_interrupted() {
  if (signal_that_came != 0) throw Interrupted();
}

int interruption() {
  return signal_that_came;
}

}  // namespace tiprub
