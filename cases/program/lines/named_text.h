// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tiprub {

/// A text file of the user's.
struct NamedText {
  std::string name;  ///< its path, for messages
  std::string text;
};

}  // namespace tiprub
