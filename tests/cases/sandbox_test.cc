// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/sandbox.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <vector>

#include "tests/cases/complaint.h"

namespace tiprub {
namespace {

constexpr double mib = 1024.0 * 1024;
constexpr SandboxLimits ample = {1024 * mib, 60};

TEST(Sandbox, GivesAllBytes) {
  const std::string bytes(1 << 20, '\0');  // more than a pipe holds
  EXPECT_EQ(made_in_sandbox([&] { return bytes + "end"; }, ample), bytes + "end");
}

TEST(Sandbox, RaisesWhatItsFunctionRaises) {
  const auto wrong = [&]() -> std::string { throw InputError("wrong"); };
  const auto failed = [&]() -> std::string { throw RunError("failed"); };
  EXPECT_EQ(complaint<InputError>([&] { made_in_sandbox(wrong, ample); }), "wrong");
  EXPECT_EQ(complaint<RunError>([&] { made_in_sandbox(failed, ample); }), "failed");
}

TEST(Sandbox, DiesAlone) {
  const auto crash = [&]() -> std::string {
    raise(SIGKILL);
    return "";
  };
  EXPECT_EQ(complaint<SandboxFailure>([&] { made_in_sandbox(crash, ample); }), "Killed");
}

TEST(Sandbox, MayTakeNoMoreThanItsLimits) {
#ifdef TIPRUB_SANITIZED
  GTEST_SKIP() << "the sanitizer maps more than any limit";
#endif
  const auto greedy = [&] { return std::to_string(std::vector<char>(1 << 30, 'x').back()); };
  EXPECT_EQ(complaint<SandboxFailure>([&] {
              made_in_sandbox(greedy, {64 * mib, 60});
            }),
            "it takes more memory than it may");
  const auto endless = [&]() -> std::string {
    for (volatile bool forever = true; forever;) {
    }
    return "";
  };
  EXPECT_EQ(complaint<SandboxFailure>([&] { made_in_sandbox(endless, {1024 * mib, 1}); }), "CPU time limit exceeded");
}

}  // namespace
}  // namespace tiprub
