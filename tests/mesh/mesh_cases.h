// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "mesh/sector/sector_mesher.h"
#include "mesh/wheels/wheel.h"

namespace tiprub::mesh::test {

/// The text of cases/<name>/case.toml.
std::string case_text(const std::string& name);

/// The text with the line "key = ..." replaced; fails the test if there is none.
std::string with(const std::string& text, const std::string& key, const std::string& value);

/// The text with more keys in [mesh], a line each.
std::string with_keys(const std::string& text, const std::string& keys);

/// An annular plate 0.1 / 0.2 / 0.001 m, one of six sectors, so many elements round it and half as many in depth.
std::string annular_plate(int elements_round, const std::string& element = "hex20");

/// A disc with twelve twisted axial blades.
std::string twisted_blades();

Wheel wheel_from(const std::string& case_text);
MeshedSector sector_from(const std::string& case_text);

/// What wheel_from or what follows it complains about; empty if nothing.
std::string complaint(const std::string& case_text);

}  // namespace tiprub::mesh::test
