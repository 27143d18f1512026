// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "postprocess/analysis/study.h"
#include "postprocess/fields/field_study.h"

namespace tiprub {

/// What the page's wheel is drawn from, packed as PackedArrays does: the surface of a sector, the natural modes, and
/// of every critical speed with a cycle its waves, the largest stress over the cycle at each node [MPa], and the
/// contact forces [N]; the contact line and the casing's shape. Where the surface has more nodes than a page can
/// hold, those between the corners of its faces are left out.
std::string wheel_data(const Response& response, const ContactLine& contact, const FieldStudy& fields);

}  // namespace tiprub
