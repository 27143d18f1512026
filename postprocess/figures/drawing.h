// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tiprub {

/// Ends of an axis or of a colour scale; a script knows those of "speed" as speed_low and speed_high.
struct DrawnRange {
  double low = 0;
  double high = 0;

  /// At least a ten-thousandth of itself wide, because gnuplot draws no empty range and tells tics apart by six
  /// digits: wider to both sides, or upwards from zero.
  DrawnRange widened() const;
};

/// What a script knows by a name: a number, a text for people, a list of either (an array, from 1), or a range.
using ScriptValue = std::variant<int, double, std::string, std::vector<double>, std::vector<std::string>, DrawnRange>;

/// Numbers that a script plots as $name; several sheets are told apart by `index 0`, `index 1`, ..
struct ScriptTable {
  std::string name;
  std::vector<Eigen::MatrixXd> sheets;
};

/// A sheet of one column.
inline Eigen::MatrixXd as_column(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// One picture: a script of scripts/ and what it reads. How it looks is the script's affair.
struct Drawing {
  std::string name{};    ///< of the files, without ending
  int width = 900;       ///< [px] of the SVG; the PNG has twice as many
  int height = 540;      ///< [px]
  std::string script{};  ///< without ending
  std::vector<std::pair<std::string, ScriptValue>> values{};
  std::vector<ScriptTable> tables{};  ///< each comes with its number of rows, <name>_rows
};

}  // namespace tiprub
