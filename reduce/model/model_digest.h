// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reduce/model/reduced_model.h"

namespace tiprub {

/// A name for all numbers that a march reads of a model: the contact line, the matrices, the frequencies that verify
/// it; 16 hexadecimal digits (see cases/program/digest.h). What is made from a model carries it.
std::string digest(const ReducedModel& model);

}  // namespace tiprub
