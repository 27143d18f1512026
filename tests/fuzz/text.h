// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/fuzz/random.h"

namespace tiprub::fuzz {

/// One change of a text (case.toml, an ASCII sector.msh): a number or a word that becomes an extreme or an odd one,
/// or one of another text; words exchanged; lines removed, doubled, moved or taken from another text.
void change_text(std::string& text, const std::string& other, Random& random);

}  // namespace tiprub::fuzz
