// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "postprocess/report/page.h"

namespace tiprub {

/// What the page's tables and first screen tell, for programs: JSON, schema "tiprub-summary". Rows are objects by the
/// columns' names, which have the units.
std::string json_summary(const ReportContents& contents);

}  // namespace tiprub
