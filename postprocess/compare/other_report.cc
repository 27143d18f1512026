// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/compare/other_report.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "cases/program/errors.h"
#include "postprocess/analysis/input_check.h"
#include "postprocess/figures/study_figures.h"
#include "postprocess/records/critical_speed_record.h"
#include "postprocess/tables/units.h"
#include "simulate/response/response_file.h"

namespace fs = std::filesystem;

namespace tiprub {

namespace {

/// As write_csv() and read_csv() would bring it over, without a file between.
CsvTable as_read(const Table& table, const std::string& file) {
  CsvTable read{file, table.header, {}};
  for (const auto& row : table.rows) {
    read.rows.emplace_back();
    for (const Cell& cell : row) read.rows.back().push_back(csv_cell(cell));
  }
  return read;
}

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && !text.empty() && end == text.data() + text.size() ? std::optional(value)
                                                                                   : std::nullopt;
}

std::vector<ComparedPeak> peaks_of(const CsvTable& critical) {
  const Eigen::VectorXd speed = critical.numbers("speed [rpm]"), amplitude = critical.numbers("amplitude [mm]"),
                        order = critical.numbers("engine order"),
                        diameter = critical.numbers("signed nodal diameter"), family = critical.numbers("family");
  const std::size_t stress = critical.column("von Mises, both [MPa]");
  std::vector<ComparedPeak> peaks;
  for (Eigen::Index i = 0; i < speed.size(); ++i)
    peaks.push_back({speed[i], amplitude[i], order[i], static_cast<int>(diameter[i]), static_cast<int>(family[i]),
                     number_in(critical.rows[static_cast<std::size_t>(i)][stress])});
  return peaks;
}

OtherReport report_of(std::string name, const CsvTable& critical, const CsvTable& response, CsvTable leading,
                      CsvTable trailing) {
  for (const CsvTable* map : {&leading, &trailing})
    for (std::size_t column = 0; column < map->header.size(); ++column) map->numbers(map->header[column]);
  return {std::move(name),
          response.numbers("speed [rpm]"),
          response.numbers("largest [mm]"),
          peaks_of(critical),
          std::move(leading),
          std::move(trailing)};
}

/// The same parameters and model, another casing, clearance, damping, ...
OtherReport from_response(const fs::path& path, const Study& study) {
  Response response = read_response(path);
  check_together(study.model, response, path.string() + " (to compare; of another model, give its report)");
  const Study other = make_study(study.parameters, study.model, std::move(response), {});
  const FieldResults none = field_results(std::nullopt, other.critical);
  return report_of(path.string(), as_read(critical_speed_record(other, none), path.string()),
                   as_read(response_figure(other).data, path.string()),
                   as_read(interaction_map_figure(other, TipEdge::leading).data, path.string()),
                   as_read(interaction_map_figure(other, TipEdge::trailing).data, path.string()));
}

}  // namespace

InteractionMap map_of(const CsvTable& table) {
  const Eigen::VectorXd speed = table.numbers("speed [rpm]"), order = table.numbers("engine order"),
                        total = table.numbers("total [mm]");
  InteractionMap map;
  for (Eigen::Index first = 0, last = 0; first < speed.size(); first = last) {
    while (last < speed.size() && speed[last] == speed[first]) ++last;
    const double step = last - first > 1 ? order[first + 1] - order[first] : 1;
    MapColumn column{speed[first] / rpm_per_rad_s, {}, {}, total.segment(first, last - first) / mm_per_m};
    column.spectrum.revolutions = step > 0 ? std::max(1, static_cast<int>(std::lround(1 / step))) : 1;
    column.spectrum.amplitude = column.total;
    map.columns.push_back(std::move(column));
  }
  return map;
}

OtherReport read_other_report(const fs::path& path, const Study& study) {
  if (!fs::is_directory(path)) return from_response(path, study);
  const fs::path figures = path / "figures";
  if (!fs::exists(path / "critical_speeds.csv") || !fs::exists(figures / "response.csv"))
    throw InputError(path.string() + ": is no report to compare with; give a report's folder, or a response.h5");
  return report_of(path.lexically_normal().string(), read_csv(path / "critical_speeds.csv"),
                   read_csv(figures / "response.csv"), read_csv(figures / "interaction_map_leading_edge.csv"),
                   read_csv(figures / "interaction_map_trailing_edge.csv"));
}

}  // namespace tiprub
