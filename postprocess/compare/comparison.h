// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/fields/field_study.h"
#include "postprocess/figures/drawing.h"

namespace tiprub::postprocess {

/// A critical speed.
struct ComparedPeak {
  double speed = 0;      ///< [rpm]
  double amplitude = 0;  ///< [mm]
  double engine_order = 0;
  int signed_nodal_diameter = 0;
  int family = 0;                ///< from 1
  std::optional<double> stress;  ///< [MPa] von Mises, spin and vibration, over a whole cycle; where the report has it
  std::optional<double> goodman = {};  ///< [1] utilisation, likewise
};

/// The numbers with which two reports are compared; their wheels may differ.
struct ReportNumbers {
  std::string name;                  ///< of the other report: its title if that differs, else its path
  std::vector<std::string> changes;  ///< keys of the case that differ: "casing.clearance: 0.2e-3, there 0.3e-3"
  Eigen::VectorXd speed, amplitude;  ///< [rpm]; [mm] the largest on the tip line
  std::vector<ComparedPeak> peaks;   ///< ascending in speed
  /// Parts and totals up to engine_order_max. Of the spectra only the numbers of lines and revolutions are set.
  InteractionMap leading_map, trailing_map;
  std::string avoid = {};      ///< the speeds to avoid in words; empty if the report does not tell them
  std::string component = {};  ///< name_of() the one of all amplitudes; empty if unknown
  std::string case_text = {};  ///< of the other report or response; empty if it has no copy
};

ReportNumbers report_numbers(const Study& study, const FieldResults& fields);

/// The file of a report that holds them, schema tiprub-numbers.
inline constexpr const char* numbers_file = "numbers.json";
std::string to_json(const ReportNumbers& numbers);

/// Reads a report's folder, or studies another response of the same model with the same parameters. Raises InputError
/// if `path` is neither.
ReportNumbers read_other_report(const std::filesystem::path& path, const Study& study);

/// Names the other report by its title, and finds the keys that differ from those of `case_text`. Does nothing if the
/// other one has no copy of its case.
void compare_cases(ReportNumbers& other, const std::string& case_text);

/// In one sentence, what differs; then what is to be kept in mind: the keys that differ, and other grids of speeds.
std::string comparison_in_words(const ReportNumbers& here, const ReportNumbers& other);

/// Critical speeds of both reports side by side, ascending in speed, with the shifts from the other report to this
/// one; a shift within rounding is 0. Two critical speeds are paired if the same wave makes them (engine order,
/// signed nodal diameter and family); of several candidates, the nearest are paired. Each unpaired one has its own
/// row.
Table comparison_record(const ReportNumbers& this_one, const ReportNumbers& other);

/// The same for each of the others, one after the other; of several, the first column names the report.
Table comparison_record(const ReportNumbers& this_one, const std::vector<ReportNumbers>& others);

/// A row for this report and for each other one: the keys of its case that differ, its largest critical speed, and
/// the speeds to avoid.
Table reports_record(const ReportNumbers& this_one, const std::vector<ReportNumbers>& others);

/// The interaction maps of both reports side by side, for the edge asked for.
Figure comparison_map_figure(const Study& study, const ReportNumbers& this_one, const ReportNumbers& other);

/// The responses of all reports over speed.
Figure comparison_figure(const ReportNumbers& this_one, const std::vector<ReportNumbers>& others);

}  // namespace tiprub::postprocess
