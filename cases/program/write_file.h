// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>

namespace tiprub {

/// A file of whatever `body` puts into the stream, byte for byte. Raises RunError with the system's reason if the
/// file can't be made, or the disk doesn't take all of it.
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& body);

}  // namespace tiprub
