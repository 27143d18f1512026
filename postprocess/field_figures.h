// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "postprocess/field_study.h"
#include "postprocess/figure.h"

namespace tiprub {

/// Pictures of the wheel: the whole and one sector, its node sets, modes, displacement and stress at the contact
/// instant of the worst critical speed (paper, figs. 1, 3, 5, 6, 16, 17). Without a contact instant the last two are
/// left out.
std::vector<Figure> field_figures(const FieldStudy& fields);

}  // namespace tiprub
