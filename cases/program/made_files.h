// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace tiprub {

/// Leaves in a folder the list of all files in it, as "made here", in the file ".tiprub-files". Raises RunError if it
/// can't be written.
void list_made_files(const std::filesystem::path& folder);

/// A file in the folder, or in one below it, that is not on its list (relative to the folder); nothing if there is
/// none. Of a folder without a list every file is a stranger.
std::optional<std::filesystem::path> first_file_not_made_here(const std::filesystem::path& folder);

}  // namespace tiprub
