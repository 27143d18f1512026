// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/compare/comparison.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cases/program/case_file.h"
#include "cases/program/errors.h"
#include "postprocess/analysis/input_check.h"
#include "postprocess/figures/axes.h"
#include "postprocess/records/speeds_to_avoid.h"
#include "postprocess/tables/table.h"
#include "simulate/response/response_file.h"

namespace fs = std::filesystem;

namespace tiprub::postprocess {

namespace {

using nlohmann::json;

constexpr const char* schema = "tiprub-numbers";
constexpr int schema_version = 1;

MapColumn map_column(double speed, int revolutions, Eigen::MatrixXd parts) {
  const Eigen::VectorXd total = parts.rowwise().sum();
  return {speed, {.revolutions = revolutions, .amplitude = total}, std::move(parts), total};
}

InteractionMap up_to(const InteractionMap& map, int engine_order_max) {
  InteractionMap low{map.node, {}};
  for (const MapColumn& column : map.columns) {
    const int revolutions = column.spectrum.revolutions,
              lines = std::min(column.spectrum.lines(), engine_order_max * revolutions + 1);
    low.columns.push_back(map_column(column.speed, revolutions, column.parts.topRows(lines)));
  }
  return low;
}

json list_of(const Eigen::VectorXd& values) {
  return std::vector<double>(values.begin(), values.end());
}

json map_json(const InteractionMap& map) {
  json columns = json::array();
  for (const MapColumn& column : map.columns) {
    json parts = json::array();
    for (const auto& part : column.parts.colwise()) parts.push_back(list_of(part * mm_per_m));
    columns.push_back({{"speed_rpm", column.speed * rpm_per_rad_s},
                       {"revolutions", column.spectrum.revolutions},
                       {"parts_mm", std::move(parts)}});
  }
  return columns;
}

void require(bool sound, const char* what) {
  if (!sound) throw InputError(what);
}

Eigen::VectorXd vector_of(const json& list) {
  const auto values = list.get<std::vector<double>>();
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

InteractionMap map_from(const json& columns) {
  InteractionMap map;
  for (const json& column : columns) {
    const json& lists = column.at("parts_mm");
    require(!lists.empty() && column.at("revolutions") >= 1, "a map has a speed without a spectrum");
    Eigen::MatrixXd parts(static_cast<Eigen::Index>(lists.at(0).size()), static_cast<Eigen::Index>(lists.size()));
    for (Eigen::Index n = 0; n < parts.cols(); ++n) {
      const Eigen::VectorXd part = vector_of(lists.at(static_cast<std::size_t>(n)));
      require(part.size() == parts.rows() && part.size() > 0, "parts of a map differ in length");
      parts.col(n) = part / mm_per_m;
    }
    map.columns.push_back(
        map_column(column.at("speed_rpm").get<double>() / rpm_per_rad_s, column.at("revolutions"), std::move(parts)));
  }
  require(!map.columns.empty(), "a map has no speeds");
  return map;
}

ComparedPeak peak_from(const json& peak) {
  const auto number = [&](const char* name) {  // that a report may have
    const json value = peak.value(name, json());
    return value.is_null() ? std::nullopt : std::optional(value.get<double>());
  };
  return {peak.at("speed_rpm"), peak.at("amplitude_mm"), peak.at("engine_order"), peak.at("signed_nodal_diameter"),
          peak.at("family"),    number("stress_mpa"),    number("goodman")};
}

ReportNumbers from_json(const json& numbers) {
  require(numbers.at("schema") == schema && numbers.at("schema_version") == schema_version,
          "is of another version; give a report that this version made");
  ReportNumbers read{{},
                     {},
                     vector_of(numbers.at("response").at("speed_rpm")),
                     vector_of(numbers.at("response").at("largest_mm")),
                     {},
                     map_from(numbers.at("maps").at("leading")),
                     map_from(numbers.at("maps").at("trailing")),
                     numbers.value("avoid", std::string()),
                     numbers.value("component", std::string())};
  require(read.speed.size() > 0 && read.speed.size() == read.amplitude.size(),
          "speeds and amplitudes differ in number");
  for (const json& peak : numbers.at("critical_speeds")) read.peaks.push_back(peak_from(peak));
  return read;
}

ReportNumbers from_folder(const fs::path& folder) {
  const fs::path file = folder / numbers_file;
  if (!fs::exists(file))
    throw InputError(folder.string() + ": has no " + numbers_file +
                     " to compare with; give the folder of a report that this version made, or a response.h5");
  const fs::path case_file = folder / "case.toml";
  try {
    ReportNumbers numbers = from_json(json::parse(read_text(file)));
    if (fs::exists(case_file)) numbers.case_text = read_text(case_file);
    return numbers;
  } catch (const json::exception& error) {
    throw InputError(file.string() + ": " + error.what());
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.what());
  }
}

/// Studies a response with the same parameters and model; casing, clearance, damping and so on may differ.
ReportNumbers from_response(const fs::path& path, const Study& study) {
  Response response = read_response(path);
  check_together(study.model, response, path.string() + " (to compare; of another model, give its report)");
  const Study other = make_study(study.parameters, study.model, std::move(response), {});
  ReportNumbers numbers = report_numbers(other, field_results(std::nullopt, other.critical));
  numbers.case_text = other.response.scene.swept_case();
  return numbers;
}

}  // namespace

ReportNumbers report_numbers(const Study& study, const FieldResults& fields) {
  const int orders = study.parameters.engine_order_max;
  ReportNumbers numbers{{},
                        {},
                        rpm_of(study.response.speeds),
                        study.amplitudes.largest * mm_per_m,
                        {},
                        up_to(study.waves.leading, orders),
                        up_to(study.waves.trailing, orders),
                        bands_in_words(speeds_to_avoid(study, fields), fields),
                        name_of(study.parameters.component)};
  for (std::size_t i = 0; i < study.critical.size(); ++i) {
    const CriticalSpeed& critical = study.critical[i];
    numbers.peaks.push_back(
        {critical.speed * rpm_per_rad_s, critical.amplitude * mm_per_m, critical.naming_wave().engine_order,
         critical.naming_wave().signed_nodal_diameter, critical.naming_wave().family + 1,
         fields.peaks[i] && fields.peaks[i]->cycle ? std::optional(fields.peaks[i]->body.both * mpa_per_pa)
                                                   : std::nullopt,
         fields.peaks[i] && fields.peaks[i]->cycle ? fields.peaks[i]->cycle->goodman : std::nullopt});
  }
  return numbers;
}

std::string to_json(const ReportNumbers& numbers) {
  json peaks = json::array();
  for (const ComparedPeak& peak : numbers.peaks)
    peaks.push_back({{"speed_rpm", peak.speed},
                     {"amplitude_mm", peak.amplitude},
                     {"engine_order", peak.engine_order},
                     {"signed_nodal_diameter", peak.signed_nodal_diameter},
                     {"family", peak.family},
                     {"stress_mpa", peak.stress ? json(*peak.stress) : json()},
                     {"goodman", peak.goodman ? json(*peak.goodman) : json()}});
  return json({{"schema", schema},
               {"schema_version", schema_version},
               {"response", {{"speed_rpm", list_of(numbers.speed)}, {"largest_mm", list_of(numbers.amplitude)}}},
               {"avoid", numbers.avoid},
               {"component", numbers.component},
               {"critical_speeds", std::move(peaks)},
               {"maps", {{"leading", map_json(numbers.leading_map)}, {"trailing", map_json(numbers.trailing_map)}}}})
             .dump() +
         "\n";
}

ReportNumbers read_other_report(const fs::path& path, const Study& study) {
  const bool folder = fs::is_directory(path);
  ReportNumbers numbers = folder ? from_folder(path) : from_response(path, study);
  numbers.name = folder ? path.lexically_normal().string() : path.string();
  return numbers;
}

void compare_cases(ReportNumbers& other, const std::string& case_text) {
  if (other.case_text.empty()) return;
  for (const auto& [key, here, there] : differing_keys(case_text, other.case_text)) {
    if (key != "title")
      other.changes.push_back(key + ": " + here.value_or("not given") + ", there " + there.value_or("not given"));
    else if (there && there->size() > 2)
      other.name = there->substr(1, there->size() - 2);
  }
}

}  // namespace tiprub::postprocess
