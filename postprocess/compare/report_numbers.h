// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/fields/field_results.h"

namespace tiprub {

/// A critical speed.
struct ComparedPeak {
  double speed = 0;      ///< [rpm]
  double amplitude = 0;  ///< [mm]
  double engine_order = 0;
  int signed_nodal_diameter = 0;
  int family = 0;                ///< from 1
  std::optional<double> stress;  ///< [MPa] von Mises, spin and vibration; where the report has it
};

/// What is compared of two reports, whose wheels may differ.
struct ReportNumbers {
  std::string name;                  ///< as the other report was given
  Eigen::VectorXd speed, amplitude;  ///< [rpm], [mm] the largest on the tip line
  std::vector<ComparedPeak> peaks;   ///< ascending in speed
  /// Parts and total up to engine_order_max; of the spectra only lines and revolutions.
  InteractionMap leading_map, trailing_map;
};

ReportNumbers report_numbers(const Study& study, const FieldResults& fields);

/// As a report keeps them in numbers.json, schema tiprub-numbers. Its lists are as long as the speeds, the critical
/// speeds or the spectra's lines.
inline constexpr const char* numbers_file = "numbers.json";
std::string to_json(const ReportNumbers& numbers);

/// From a report's folder, or from another response of the same model, which is studied with the same parameters.
/// Raises InputError if it is neither.
ReportNumbers read_other_report(const std::filesystem::path& path, const Study& study);

}  // namespace tiprub
