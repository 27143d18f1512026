// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/progress.h"

#include <unistd.h>

#include <cstdio>

namespace tiprub {

namespace {
constexpr int bar_width = 30;
}

Progress::Progress(std::string what, std::size_t total, Shown shown)
    : what_(std::move(what)),
      total_(total),
      visible_(shown == Shown::on_a_terminal && isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()) {
  draw();
}

Progress::~Progress() {
  if (visible_) std::fprintf(stderr, "\r\033[K");
}

void Progress::advance() {
  const std::lock_guard lock(mutex_);
  ++done_;
  draw();
}

void Progress::draw() const {
  if (!visible_ || total_ == 0) return;
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
  const double left =
      done_ == 0 ? 0.0 : spent.count() * static_cast<double>(total_ - done_) / static_cast<double>(done_);
  const int filled = static_cast<int>(bar_width * done_ / total_);
  const std::string bar = std::string(filled, '#') + std::string(bar_width - filled, '.');
  std::fprintf(stderr, "\r\033[K%s [%s] %zu/%zu", what_.c_str(), bar.c_str(), done_, total_);
  if (done_ > 0) std::fprintf(stderr, ", %d:%02d left", static_cast<int>(left) / 60, static_cast<int>(left) % 60);
  std::fflush(stderr);
}

}  // namespace tiprub
