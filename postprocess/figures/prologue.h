// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "postprocess/figures/drawing.h"

namespace tiprub {

/// What gnuplot runs for a drawing: its values and tables as assignments, then scripts/draw.gp. The only place that
/// writes gnuplot's language.
std::string prologue(const Drawing& drawing);

/// A text between single quotes, where gnuplot runs nothing and replaces nothing (single quotes themselves as an
/// escape between double ones); letters that its enhanced mode would read as markup are escaped, line ends become
/// blanks. It is shown as it stands, whatever a case calls its things.
std::string gnuplot_text(const std::string& text);

}  // namespace tiprub
