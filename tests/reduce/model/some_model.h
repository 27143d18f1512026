// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/model/reduced_model.h"

namespace tiprub::reduce::test {

/// Any model that check() lets pass: four sectors, one contact node, 3 + 2 dofs.
ReducedModel some_model();

}  // namespace tiprub::reduce::test
