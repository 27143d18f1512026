// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace tiprub {

/// A text file of the user's.
struct NamedText {
  std::string name;  ///< its path, for messages
  std::string text;
};

/// Reads all of a file. `kind` is what should be there, for messages ("a case file"). A folder, a device or a pipe is
/// none: they might never end. Raises RunError where it can't be read, and InputError where it is too large or not
/// UTF-8.
NamedText read_named_text(const std::filesystem::path& path, const std::string& kind);

}  // namespace tiprub
