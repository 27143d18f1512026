// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reduce/model/hdf5_file.h"
#include "reduce/model/reduced_model.h"

namespace tiprub::reduce::test {

/// Any model that check() lets pass: four sectors, one contact node, 3 + 2 dofs.
ReducedModel some_model();

/// A mass on three springs, 2 rad/s, as somebody would write it by hand.
void write_one_mass(Hdf5File& file, const std::string& arc_unit = "m");

}  // namespace tiprub::reduce::test
