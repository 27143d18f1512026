// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/tables/read_csv.h"

namespace tiprub {

/// A critical speed of a table.
struct ComparedPeak {
  double speed = 0;      ///< [rpm]
  double amplitude = 0;  ///< [mm]
  double engine_order = 0;
  int signed_nodal_diameter = 0;
  int family = 0;                ///< from 1
  std::optional<double> stress;  ///< [MPa] von Mises, spin and vibration; where the report has it
};

/// What another report says, to lay beside a study. Its tables tell all: another report need not have the same
/// wheel.
struct OtherReport {
  std::string name;                    ///< as it was given
  Eigen::VectorXd speed, amplitude;    ///< [rpm], [mm] the largest on the tip line
  std::vector<ComparedPeak> peaks;     ///< ascending in speed
  CsvTable leading_map, trailing_map;  ///< as in the figures' tables
};

/// The total of an interaction map's table by speed and spectral line; its parts are left in the table.
InteractionMap map_of(const CsvTable& table);

/// From a report's folder, or from another response of the same model, which is studied with the same parameters.
/// Raises InputError if it is neither.
OtherReport read_other_report(const std::filesystem::path& path, const Study& study);

}  // namespace tiprub
