// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/model/reduced_model.h"

namespace tiprub {

/// A model's frequencies against those of the unreduced sector that it came with.
struct ModelError {
  int frequencies = 0;  ///< of the wheel, from the lowest; 0: the model came without any to compare with
  double error = 0;     ///< [1] the largest relative one of them, over all verified speeds
  double speed = 0;     ///< [rad/s] where it is
};

/// The error of at most `most` of the wheel's first frequencies (the paper counts 50), of which those of nodal
/// diameters strictly between 0 and N/2 count twice. Frequencies above the lowest of the nodal diameters' last ones
/// are left out, because others may be missing there.
ModelError model_error(const ReducedModel& model, int most = 50);

}  // namespace tiprub
