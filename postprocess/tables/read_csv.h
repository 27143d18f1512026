// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <filesystem>
#include <string>
#include <vector>

namespace tiprub {

/// A table as write_csv() wrote it, all cells as text.
struct CsvTable {
  std::string file;  ///< for messages
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;

  /// Raises InputError if there is no such column.
  std::size_t column(const std::string& name) const;
  /// Likewise, or if one of its cells is no finite number.
  Eigen::VectorXd numbers(const std::string& name) const;
};

/// Raises InputError if the rows differ in length, RunError if the file can't be read.
CsvTable read_csv(const std::filesystem::path& path);

}  // namespace tiprub
