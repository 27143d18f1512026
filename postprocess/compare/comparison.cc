// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/compare/comparison.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "postprocess/figures/maps.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

/// A critical speed of this report, of the other one, or of both.
struct PeakPair {
  std::optional<ComparedPeak> here, there;

  const ComparedPeak& any() const { return here ? *here : *there; }
};

bool same_wave(const ComparedPeak& a, const ComparedPeak& b) {
  return a.signed_nodal_diameter == b.signed_nodal_diameter && a.family == b.family &&
         std::abs(a.engine_order - b.engine_order) < 1e-6;
}

/// Peaks of other waves that lie as near as this are one critical speed that another wave makes.
constexpr double same_place = 0.01;  // of the speed

/// Pairs by the same wave, then by the same place, the nearest two first.
std::vector<PeakPair> pairs_of(const std::vector<ComparedPeak>& here, const std::vector<ComparedPeak>& there) {
  std::vector<std::pair<std::size_t, std::size_t>> candidates;
  const auto other_wave = [&](const auto& pair) { return !same_wave(here[pair.first], there[pair.second]); };
  const auto apart = [&](const auto& pair) { return std::abs(here[pair.first].speed - there[pair.second].speed); };
  for (std::size_t i = 0; i < here.size(); ++i)
    for (std::size_t k = 0; k < there.size(); ++k)
      if (const std::pair pair{i, k}; !other_wave(pair) || apart(pair) < same_place * here[i].speed)
        candidates.push_back(pair);
  std::ranges::stable_sort(candidates, [&](const auto& a, const auto& b) {
    return other_wave(a) != other_wave(b) ? other_wave(b) : apart(a) < apart(b);
  });
  std::vector<char> taken_here(here.size(), 0), taken_there(there.size(), 0);
  std::vector<PeakPair> pairs;
  for (const auto& [i, k] : candidates) {
    if (taken_here[i] || taken_there[k]) continue;
    taken_here[i] = taken_there[k] = 1;
    pairs.push_back({here[i], there[k]});
  }
  for (std::size_t i = 0; i < here.size(); ++i)
    if (!taken_here[i]) pairs.push_back({here[i], std::nullopt});
  for (std::size_t k = 0; k < there.size(); ++k)
    if (!taken_there[k]) pairs.push_back({std::nullopt, there[k]});
  std::ranges::stable_sort(pairs, {}, [](const PeakPair& pair) { return pair.any().speed; });
  return pairs;
}

std::string wave_of(const ComparedPeak& peak) {
  return wave_name(peak.engine_order, peak.signed_nodal_diameter);
}

/// `value`: a member of ComparedPeak.
template <class Value>
Cell value_of(const std::optional<ComparedPeak>& peak, Value value) {
  return optional_cell(peak ? std::optional<double>(std::invoke(value, *peak)) : std::nullopt);
}

/// The change [%] relative to the other report; 0 if it is within rounding.
template <class Value>
Cell change_of(const PeakPair& pair, Value value) {
  constexpr double same = 1e-8;
  if (!pair.here || !pair.there) return optional_cell(std::nullopt);
  const std::optional<double> here = std::invoke(value, *pair.here), there = std::invoke(value, *pair.there);
  if (!here || !there || *there == 0) return optional_cell(std::nullopt);
  const double change = *here / *there - 1;
  return std::abs(change) < same ? 0.0 : percent * change;
}

/// Whether the amplitudes of two reports are of the same component.
bool are_comparable(const ReportNumbers& here, const ReportNumbers& other) {
  return other.component.empty() || other.component == here.component;
}

/// [rpm] A range with all speeds of both.
DrawnRange speed_axis_of_both(const ReportNumbers& here, const ReportNumbers& other) {
  return DrawnRange{std::min(here.speed.minCoeff(), other.speed.minCoeff()),
                    std::max(here.speed.maxCoeff(), other.speed.maxCoeff())}
      .widened();
}

/// "a, b and c"
std::string enumerated(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
  return text;
}

/// Reports with and without stresses have only the amplitude in common.
const ComparedPeak& largest_of(const std::vector<ComparedPeak>& peaks) {
  return *std::ranges::max_element(peaks, {}, &ComparedPeak::amplitude);
}

std::string peak_text(const ComparedPeak& peak) {
  return fixed(peak.amplitude, 3) + " mm at " + fixed(peak.speed, 0) + " rpm (" + wave_of(peak) + ")";
}

std::string signed_percent(double ratio) {
  return (ratio < 1 ? "" : "+") + fixed(percent * (ratio - 1), 1) + " %";
}

/// Speeds that only one of the two has move and lower the peaks between them.
std::string grids_text(const ReportNumbers& here, const ReportNumbers& other) {
  constexpr double same_speed = 1e-9;
  const bool same = here.speed.size() == other.speed.size() && here.speed.isApprox(other.speed, same_speed);
  return same ? ""
              : " The speeds differ: " + std::to_string(here.speed.size()) + " from " + fixed(here.speed[0], 0) +
                    " to " + fixed(here.speed.tail<1>()[0], 0) + " rpm here, " + std::to_string(other.speed.size()) +
                    " from " + fixed(other.speed[0], 0) + " to " + fixed(other.speed.tail<1>()[0], 0) +
                    " rpm there. A peak between speeds that are far apart is lower and elsewhere for that alone.";
}

}  // namespace

Table comparison_record(const ReportNumbers& this_one, const ReportNumbers& other) {
  const auto here = [](auto value) { return [value](const PeakPair& pair) { return value_of(pair.here, value); }; };
  const auto there = [](auto value) { return [value](const PeakPair& pair) { return value_of(pair.there, value); }; };
  const auto change = [](auto value) { return [value](const PeakPair& pair) { return change_of(pair, value); }; };
  return table_of<PeakPair>({{"wave",
                              [](const PeakPair& pair) {
                                const std::string wave = wave_of(pair.any());
                                return Cell(pair.here && pair.there && !same_wave(*pair.here, *pair.there)
                                                ? wave + ", there " + wave_of(*pair.there)
                                                : wave);
                              }},
                             {"speed [rpm]", here(&ComparedPeak::speed)},
                             {"other speed [rpm]", there(&ComparedPeak::speed)},
                             {"shift [%]", change(&ComparedPeak::speed)},
                             {"amplitude [mm]", here(&ComparedPeak::amplitude)},
                             {"other amplitude [mm]", there(&ComparedPeak::amplitude)},
                             {"change of amplitude [%]",
                              [comparable = are_comparable(this_one, other)](const PeakPair& pair) {
                                return comparable ? change_of(pair, &ComparedPeak::amplitude)
                                                  : optional_cell(std::nullopt);
                              }},
                             {"von Mises, both [MPa]", here(&ComparedPeak::stress)},
                             {"other von Mises, both [MPa]", there(&ComparedPeak::stress)},
                             {"change of stress [%]", change(&ComparedPeak::stress)}},
                            pairs_of(this_one.peaks, other.peaks));
}

Table comparison_record(const ReportNumbers& this_one, const std::vector<ReportNumbers>& others) {
  if (others.size() == 1) return comparison_record(this_one, others.front());
  Table all;
  for (const ReportNumbers& other : others) {
    Table one = comparison_record(this_one, other);
    all.header = std::move(one.header);
    all.header.insert(all.header.begin(), "report");
    for (std::vector<Cell>& row : one.rows) {
      row.insert(row.begin(), other.name);
      all.rows.push_back(std::move(row));
    }
  }
  return all;
}

std::string comparison_in_words(const ReportNumbers& here, const ReportNumbers& other) {
  const bool comparable = are_comparable(here, other);
  std::string text;
  if (here.peaks.empty() || other.peaks.empty()) {
    text = std::to_string(here.peaks.size()) + " critical speeds here, " + std::to_string(other.peaks.size()) +
           " there.";
  } else {
    const ComparedPeak &largest = largest_of(here.peaks), &there = largest_of(other.peaks);
    text = "The largest critical speed is " + peak_text(largest) + " here and " + peak_text(there) +
           " there: speed " + signed_percent(largest.speed / there.speed) +
           (comparable ? ", amplitude " + signed_percent(largest.amplitude / there.amplitude) : "") + "; " +
           std::to_string(here.peaks.size()) + " critical speeds here, " + std::to_string(other.peaks.size()) +
           " there.";
  }
  if (!other.changes.empty()) text += " The cases differ in " + listed(other.changes, "; ");
  if (!comparable)
    text += std::string(other.changes.empty() ? "" : ".") + " Amplitudes cannot be compared: here of the " +
            here.component + ", there of the " + other.component + ".";
  else if (!other.changes.empty())
    text += ".";
  return text + grids_text(here, other);
}

Table reports_record(const ReportNumbers& this_one, const std::vector<ReportNumbers>& others) {
  Table table{{"report", "keys that differ", "critical speeds", "largest [rpm]", "its wave", "its amplitude [mm]",
               "its stress with spin [MPa]", "its Goodman", "speeds to avoid"},
              {}};
  const auto add = [&](const ReportNumbers& numbers, const std::string& name) {
    std::vector<Cell> row = {name, listed(numbers.changes, "; "), static_cast<int>(numbers.peaks.size())};
    if (numbers.peaks.empty()) {
      row.insert(row.end(), 5, std::string());
    } else {
      const ComparedPeak& largest = largest_of(numbers.peaks);
      row.insert(row.end(), {largest.speed, wave_of(largest), largest.amplitude, optional_cell(largest.stress),
                             optional_cell(largest.goodman)});
    }
    row.emplace_back(numbers.avoid);
    table.rows.push_back(std::move(row));
  };
  add(this_one, "this report");
  for (const ReportNumbers& other : others) add(other, other.name);
  return table;
}

Figure comparison_map_figure(const Study& study, const ReportNumbers& this_one, const ReportNumbers& other) {
  constexpr int columns = 420, rows = 360;
  const bool leading = study.parameters.edge == TipEdge::leading;
  const InteractionMap &here = leading ? this_one.leading_map : this_one.trailing_map,
                       &there = leading ? other.leading_map : other.trailing_map;
  const SpeedFrame own = speed_frame(study);
  const double high = std::max(map_amplitude_high(study.waves), there.largest() * mm_per_m);
  const MapFrame frame{speed_axis_of_both(this_one, other),
                       map_frequency_high(own),
                       {high * std::pow(10.0, -study.parameters.amplitude_decades), high}};
  Figure figure =
      listed_figure("comparison_map", {{"edge", name_of(study.parameters.edge)},
                                       {"other", other.name},
                                       {"engine_order_max", std::to_string(study.parameters.engine_order_max)}});
  figure.data = {{"report", "speed [rpm]", "engine order", "total [mm]"}, {}};
  set_map_axes(figure.drawing, own, frame);
  figure.drawing.values.emplace_back("map_title", std::vector<std::string>{"this report", other.name});
  set_pixels(figure, map_pixels(here, own.failed, frame, columns, rows));
  figure.pixels.front().file = "comparison_map_1.pixels";
  figure.pixels.push_back({"comparison_map_2.pixels", map_pixels(there, {}, frame, columns, rows)});
  for (const auto& [name, map] : {std::pair{"this", &here}, std::pair{"other", &there}})
    for (const MapColumn& column : map->columns)
      for (int line = 0; line < column.spectrum.lines(); ++line)
        if (const double order = column.spectrum.engine_order(line); order <= study.parameters.engine_order_max)
          figure.data.rows.push_back({name, column.speed * rpm_per_rad_s, order, column.total[line] * mm_per_m});
  return figure;
}

Figure comparison_figure(const ReportNumbers& this_one, const std::vector<ReportNumbers>& others) {
  const auto curve = [](const ReportNumbers& numbers) {
    Eigen::MatrixXd rows(numbers.speed.size(), 2);
    rows << numbers.speed, numbers.amplitude;
    return rows;
  };
  DrawnRange axis = speed_axis_of_both(this_one, this_one);
  std::vector<std::string> names;
  std::vector<Eigen::MatrixXd> there;
  for (const ReportNumbers& other : others) {
    const DrawnRange both = speed_axis_of_both(this_one, other);
    axis = {std::min(axis.low, both.low), std::max(axis.high, both.high)};
    names.push_back(other.name);
    there.push_back(curve(other));
  }
  Figure figure = listed_figure("comparison", {{"other", enumerated(names)}});
  figure.drawing.values = {{"speed", axis}, {"other_name", names}, {"others", static_cast<int>(names.size())}};
  figure.data = {{"response", "speed [rpm]", "amplitude [mm]"}, {}};
  const auto add = [&](const std::string& name, const Eigen::MatrixXd& rows) {
    for (const auto& row : rows.rowwise()) figure.data.rows.push_back({name, row[0], row[1]});
  };
  add("this", curve(this_one));
  for (std::size_t k = 0; k < others.size(); ++k) add(others.size() == 1 ? "other" : names[k], there[k]);
  figure.drawing.tables = {{"here", {curve(this_one)}}, {"there", std::move(there)}};
  return figure;
}

}  // namespace tiprub::postprocess
