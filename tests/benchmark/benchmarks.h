// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/benchmark/bench_wheel.h"

namespace tiprub::simulate::testing {

/// What a step of the default costs in contact and in the air, with the bound by its bytes and flops (step_bound.h),
/// beside the dense form (the paper's eqs. 13, 14 and 15 as printed) and a plain modal transform of the whole wheel.
/// All marches are timed in turn, and the medians are printed as a table to stdout.
void print_step_costs(const std::string& model);

/// How time and memory of a march grow over blades, lobes, contact nodes, dofs and damping of made-up wheels, with
/// the fitted exponents; a table to stdout.
void print_scaling();

/// What 400 speeds by 60 revolutions cost against three lobes, all of it (set-up, march, recording, audit): marches
/// `speeds` of them, evenly spread, and scales up; to stdout.
void print_sweep_cost(const std::string& model, int speeds);

/// Error of the settled response against a 16 times finer run of the default, over cost, for every scheme and step,
/// for numbers of modes, and symmetric against full; a table to stdout.
void print_accuracy(const std::string& model);

/// What the default and central differences say of each speed of a sweep; a table to stdout. Whether they agree at 95
/// % or more of them.
bool print_scheme_agreement(const std::string& model, int speeds);

/// What the settled answer costs by marching and as an orbit (steady_state), with light and with high damping: each
/// speed beside the other, in one run; a table to stdout.
void print_orbit_cost(const std::string& model, int lobes, int speeds);

/// Maps of failure, scheme over step on the given wheel and the others on made-up ones: a cell says stable,
/// inaccurate, chatters, grows, or refused, and what becomes of it when it is marched all the same; a table to
/// stdout.
void print_stability(const std::string& model);

}  // namespace tiprub::simulate::testing
