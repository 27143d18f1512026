// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace tiprub {

/// The keys of a case's text, "mesh.density", with their values as they are written, without comments and blanks. The
/// copy that an output keeps has the keys of the command line behind "# --set ".
std::map<std::string, std::string> written_keys(const std::string& text);

}  // namespace tiprub
