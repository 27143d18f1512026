// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tiprub::fuzz {

enum class Format { text, mesh, hdf5 };

/// All that reads one of the files between the stages.
struct Reader {
  std::string name;  ///< "case"
  std::string end;   ///< of its files, ".toml"
  Format format;
  /// Reads a file; what belongs to it (case.toml, sector.msh, model.h5, response.h5) lies in the folder `beside`.
  using Part = std::function<void(const std::filesystem::path& file, const std::filesystem::path& beside)>;
  std::vector<Part> parts;  ///< each for itself accepts or raises
};

/// Raises std::out_of_range if there is none of this name.
const Reader& reader_named(const std::string& name);

}  // namespace tiprub::fuzz
