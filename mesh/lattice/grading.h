// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tiprub {

/// Where half of an element index, 0 .. 2 count, lies along a direction whose elements grow by the same factor from
/// both ends to the middle: as the half index that stands there when all are alike. `ratio` is the largest element
/// over the smallest; one or two are alike whatever it is. Mid-side nodes stay in the middle of their elements.
double graded(int half_index, int count, double ratio);

}  // namespace tiprub
