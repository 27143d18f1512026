// SPDX-License-Identifier: GPL-3.0-or-later
// Amplitudes over speed: the response, sweeps and branches, trackings.
#include <algorithm>
#include <numeric>

#include "postprocess/analysis/interaction_map.h"
#include "postprocess/figures/study_figures.h"
#include "postprocess/records/study_records.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

Table amplitude_table(const Eigen::VectorXd& rpm, const TipAmplitudes& amplitudes) {
  Table table{{"speed [rpm]", "largest [mm]", "leading edge [mm]", "trailing edge [mm]", "node of the largest"}, {}};
  for (Eigen::Index i = 0; i < rpm.size(); ++i)
    table.rows.push_back({rpm[i], amplitudes.largest[i] * mm_per_m, amplitudes.by_node(0, i) * mm_per_m,
                          amplitudes.by_node(amplitudes.trailing_edge, i) * mm_per_m, amplitudes.node[i]});
  return table;
}

/// Speed [rpm], amplitude [mm] where the motion is not the same at every lobe.
Eigen::MatrixXd not_periodic(const std::vector<SpeedResponse>& speeds, const TipAmplitudes& amplitudes) {
  std::vector<std::array<double, 2>> rows;
  for (std::size_t i = 0; i < speeds.size(); ++i)
    if (speeds[i].motion != MotionClass::periodic)
      rows.push_back({speeds[i].speed * rpm_per_rad_s, amplitudes.largest[static_cast<Eigen::Index>(i)] * mm_per_m});
  return as_sheet(rows);
}

/// Speed [rpm], amplitude [mm].
Eigen::MatrixXd peaks(const std::vector<CriticalSpeed>& critical) {
  std::vector<std::array<double, 2>> rows;
  for (const CriticalSpeed& peak : critical) rows.push_back({peak.speed * rpm_per_rad_s, peak.amplitude * mm_per_m});
  return as_sheet(rows);
}

/// The waves that make the peaks: "EO 6 ND -4", or "mixed".
std::vector<std::string> peak_names(const std::vector<CriticalSpeed>& all) {
  std::vector<std::string> names;
  for (const CriticalSpeed& critical : all) names.push_back(critical.is_mixed() ? "mixed" : wave_names(critical));
  return names;
}

/// Bands of speeds to avoid: ends [rpm], and the grade of the concern.
ScriptTable bands(const std::vector<AvoidedBand>& avoided) {
  std::vector<std::array<double, 3>> rows;
  for (const auto& [speeds, concern, widening] : avoided)
    rows.push_back({speeds.low * rpm_per_rad_s, speeds.high * rpm_per_rad_s, static_cast<double>(concern)});
  return {"bands", {as_sheet(rows)}};
}

/// For the key: the concerns by grade, empty where no band has it.
std::vector<std::string> concern_names(const std::vector<AvoidedBand>& avoided) {
  std::vector<std::string> names(concerns);
  for (const AvoidedBand& band : avoided) names[static_cast<std::size_t>(band.concern)] = name_of(band.concern);
  return names;
}

/// Speed [rpm] and stress of the vibration [MPa] at the critical speeds whose stress was recovered over a cycle, or
/// at one instant only.
Eigen::MatrixXd recovered_stress(const FieldResults& fields, bool over_cycle) {
  std::vector<std::array<double, 2>> rows;
  for (const std::optional<FieldPeak>& peak : fields.peaks)
    if (peak && peak->cycle.has_value() == over_cycle)
      rows.push_back({peak->speed * rpm_per_rad_s, peak->body.vibration * mpa_per_pa});
  return as_sheet(rows);
}

/// [rpm]
Eigen::MatrixXd speeds_of(const std::vector<Crossing>& crossings) {
  std::vector<double> speeds;
  speeds.reserve(crossings.size());
  for (const Crossing& crossing : crossings) speeds.push_back(crossing.speed * rpm_per_rad_s);
  return as_column(speeds);
}

/// Speed [rpm], amplitudes from rest, up and down [mm], the last two again where they differ; NaN where there is
/// none.
Eigen::MatrixXd sweep_rows(const Eigen::VectorXd& rpm, const TipAmplitudes& amplitudes,
                           const std::vector<SweepComparison>& sweeps) {
  Eigen::MatrixXd rows = Eigen::MatrixXd::Constant(rpm.size(), 6, std::nan(""));
  rows.col(0) = rpm;
  rows.col(1) = amplitudes.largest * mm_per_m;
  for (const SweepComparison& comparison : sweeps) {
    const Eigen::Index i = comparison.index;
    const auto enter = [&](const std::optional<SweptSpeed>& swept, Eigen::Index column) {
      if (swept) rows(i, column) = swept->amplitude * mm_per_m;
      if (swept && swept->differs) rows(i, column + 2) = swept->amplitude * mm_per_m;
    };
    enter(comparison.up, 2);
    enter(comparison.down, 3);
  }
  return rows;
}

/// Speed [rpm], amplitude [mm] of each run of orbits that attract, or that repel. Runs that repel extend to the
/// neighbouring orbits, so that no gap is drawn.
std::vector<Eigen::MatrixXd> runs(const OrbitBranch& branch, bool attracting) {
  std::vector<Eigen::MatrixXd> found;
  const Eigen::Index count = branch.speed.size();
  for (Eigen::Index first = 0, last = 0; first < count; first = last + 1) {
    for (last = first; last + 1 < count && branch.attracts(last + 1) == branch.attracts(first);) ++last;
    if (branch.attracts(first) != attracting) continue;
    const Eigen::Index from = attracting ? first : std::max<Eigen::Index>(first - 1, 0);
    const Eigen::Index to = attracting ? last : std::min(last + 1, count - 1);
    Eigen::MatrixXd run(to - from + 1, 2);
    run << branch.speed.segment(from, run.rows()) * rpm_per_rad_s,
        branch.amplitude.segment(from, run.rows()) * mm_per_m;
    found.push_back(run);
  }
  return found;
}

/// What one panel follows over speed.
struct Panel {
  std::string title;
  HarmonicTracking tracking;
};

/// "EO 1", "EO 2", ..
std::vector<std::string> numbered(const std::string& word, const std::vector<int>& numbers) {
  std::vector<std::string> names;
  for (const int number : numbers) names.push_back(word + " " + std::to_string(number));
  return names;
}

std::vector<int> counted_from(int first, Eigen::Index count) {
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

/// `count` of the engine orders 1 .. last, ascending: those that become largest on a nodal diameter at any speed.
std::vector<int> largest_engine_orders(const InteractionMap& map, int last, std::size_t count) {
  std::vector<int> orders = counted_from(1, last);
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(last + 1);
  for (const int order : orders) largest[order] = nodal_diameter_tracking(map, order).curves.maxCoeff();
  std::ranges::stable_sort(orders, [&](int a, int b) { return largest[a] > largest[b]; });
  orders.resize(std::min(count, orders.size()));
  std::ranges::sort(orders);
  return orders;
}

void append(Table& table, const Panel& panel, const std::string& curve, const Eigen::VectorXd& rpm,
            const Eigen::VectorXd& amplitude) {
  for (Eigen::Index i = 0; i < rpm.size(); ++i)
    table.rows.push_back({panel.title, rpm[i], curve, amplitude[i] * mm_per_m});
}

Table tracking_table(const Eigen::VectorXd& rpm, const std::vector<Panel>& panels,
                     const std::vector<std::string>& names) {
  Table table{{"followed", "speed [rpm]", "curve", "amplitude [mm]"}, {}};
  for (const Panel& panel : panels) {
    for (std::size_t k = 0; k < names.size(); ++k)
      append(table, panel, names[k], rpm, panel.tracking.curves.col(static_cast<Eigen::Index>(k)));
    append(table, panel, "mean", rpm, panel.tracking.mean);
  }
  return table;
}

/// `names`: those of the curves, the same in each panel.
Figure tracking_figure(const SpeedFrame& frame, const std::string& name, const std::vector<Panel>& panels,
                       const std::vector<std::string>& names) {
  ScriptTable curves{"curves", {}};
  std::vector<std::string> titles;
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(names.size()));
  for (const Panel& panel : panels) {
    Eigen::MatrixXd rows(panel.tracking.mean.size(), 2 + panel.tracking.curves.cols());
    rows << frame.speeds, panel.tracking.mean * mm_per_m, panel.tracking.curves * mm_per_m;
    curves.sheets.push_back(rows);
    titles.push_back(panel.title);
    largest = largest.cwiseMax(panel.tracking.curves.colwise().maxCoeff().transpose());
  }
  constexpr double in_key = 1e-3;  // of the largest curve; the key names no curve that can't be seen
  std::vector<std::string> keys = names;
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (largest[static_cast<Eigen::Index>(k)] < in_key * largest.maxCoeff()) keys[k].clear();
  const int count = static_cast<int>(panels.size());
  Figure figure = listed_figure(name);
  figure.drawing.height = 90 + 270 * count;
  figure.drawing.values = {{"speed", frame.axis},
                           {"panels", count},
                           {"panel_title", titles},
                           {"curves", static_cast<int>(names.size())},
                           {"curve_name", keys}};
  figure.drawing.tables = {curves};
  figure.data = tracking_table(frame.speeds, panels, names);
  return figure;
}

/// The nodal diameters, the one with the most motion first.
std::vector<int> by_energy(const InteractionMap& map) {
  const Eigen::VectorXd shares = energy_shares(map);
  std::vector<int> order(static_cast<std::size_t>(shares.size()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](int a, int b) { return shares[a] > shares[b]; });
  return order;
}

}  // namespace

Figure response_figure(const SpeedFrame& frame, const TipAmplitudes& amplitudes, const LinearRules& rules,
                       const std::vector<SpeedResponse>& speeds, Component component,
                       const std::vector<AvoidedBand>& avoided) {
  const double highest = amplitudes.largest.maxCoeff();
  Figure figure = listed_figure("response", {{"component", name_of(component)}});
  figure.drawing.values = {{"speed", frame.axis},
                           {"amplitude", DrawnRange{0, highest > 0 ? highest * mm_per_m : 1}},
                           {"peak_name", peak_names(frame.critical)},
                           {"concern", concern_names(avoided)}};
  figure.drawing.tables = {bands(avoided),
                           {"peaks", {peaks(frame.critical)}},
                           {"not_periodic", {not_periodic(speeds, amplitudes)}},
                           {"aliased", {speeds_of(drawn_crossings(frame, rules.aliased))}},
                           {"equation_2", {speeds_of(drawn_crossings(frame, rules.equation_2))}},
                           {"failed", {frame.failed}},
                           {"outside", {frame.outside}}};
  figure.data = amplitude_table(frame.speeds, amplitudes);
  return figure;
}

Figure stress_figure(const SpeedFrame& frame, const FieldResults& fields, const std::vector<AvoidedBand>& avoided) {
  const StressCycle* const worst = fields.worst_cycle();
  const double allowed = worst != nullptr ? allowed_alternating(*worst) * mpa_per_pa : 0;
  const double yield = worst != nullptr ? worst->strength->yield.value_or(0) * mpa_per_pa : 0;
  const Eigen::VectorXd estimated = fields.over_speed * mpa_per_pa;
  const Eigen::MatrixXd recovered = recovered_stress(fields, true), at_least = recovered_stress(fields, false);
  double most_recovered = 0;
  for (const Eigen::MatrixXd* found : {&recovered, &at_least})
    if (found->rows() > 0) most_recovered = std::max(most_recovered, found->col(1).maxCoeff());
  Figure figure = listed_figure("stress");
  figure.drawing.values = {
      {"speed", frame.axis},
      {"stress", DrawnRange{0, std::max({estimated.maxCoeff(), most_recovered, allowed, yield})}},
      {"allowed", allowed},
      {"allowed_name", worst != nullptr ? "Goodman's rule allows, at a mean of " + mpa_text(worst->mean) : ""},
      {"yield", yield},
      {"concern", concern_names(avoided)}};
  figure.drawing.tables = {bands(avoided), {"recovered", {recovered}}, {"at_least", {at_least}}};
  figure.data.header = {"speed [rpm]", "von Mises, vibration, estimated [MPa]"};
  for (Eigen::Index i = 0; i < estimated.size(); ++i) figure.data.rows.push_back({frame.speeds[i], estimated[i]});
  return figure;
}

Figure sweeps_figure(const SpeedFrame& frame, const TipAmplitudes& amplitudes,
                     const std::vector<SweepComparison>& sweeps, Table record) {
  Figure figure = listed_figure("sweeps");
  figure.drawing.values = {{"speed", frame.axis}, {"sweeps_drawn", 1}};
  figure.drawing.tables = {
      {"sweeps", {sweep_rows(frame.speeds, amplitudes, sweeps)}}, {"attracting", {}}, {"repelling", {}}};
  figure.data = std::move(record);
  return figure;
}

Figure branches_figure(const TipAmplitudes& amplitudes, const Eigen::VectorXd& speeds,
                       const std::vector<SweepComparison>& sweeps, const std::vector<OrbitBranch>& branches) {
  ScriptTable attracting{"attracting", {}}, repelling{"repelling", {}};
  DrawnRange range{branches.front().speed[0] * rpm_per_rad_s, 0};
  for (const OrbitBranch& branch : branches) {
    for (const Eigen::MatrixXd& run : runs(branch, true)) attracting.sheets.push_back(run);
    for (const Eigen::MatrixXd& run : runs(branch, false)) repelling.sheets.push_back(run);
    range.low = std::min(range.low, branch.speed.minCoeff() * rpm_per_rad_s);
    range.high = std::max(range.high, branch.speed.maxCoeff() * rpm_per_rad_s);
  }
  Figure figure = listed_figure("branches");
  figure.drawing.values = {{"speed", range}, {"sweeps_drawn", sweeps.empty() ? 0 : 1}};
  figure.drawing.tables = {
      {"sweeps", {sweep_rows(speeds, amplitudes, sweeps)}}, std::move(attracting), std::move(repelling)};
  figure.data = branch_record(branches);
  return figure;
}

Figure nodal_diameter_tracking_figure(const SpeedFrame& frame, const InteractionMap& map) {
  constexpr std::size_t followed = 3;
  std::vector<Panel> panels;
  for (const int order : largest_engine_orders(map, frame.engine_order_max, followed))
    panels.push_back({"EO " + std::to_string(order), nodal_diameter_tracking(map, order)});
  return tracking_figure(frame, "nodal_diameter_tracking", panels,
                         numbered("ND", counted_from(0, panels.front().tracking.curves.cols())));
}

Figure engine_order_tracking_figure(const SpeedFrame& frame, const InteractionMap& map) {
  constexpr std::size_t followed = 3, averaged = 6;
  constexpr double moving = 0.01;  // of the mean square of the motion
  const std::vector<int> engine_orders = largest_engine_orders(map, frame.engine_order_max, averaged);
  const Eigen::VectorXd shares = energy_shares(map);
  std::vector<Panel> panels;
  const std::vector<int> nodal_diameters = by_energy(map);
  for (std::size_t k = 0; k < std::min(followed, nodal_diameters.size()); ++k)
    if (k == 0 || shares[nodal_diameters[k]] > moving)
      panels.push_back({"nodal diameter " + std::to_string(nodal_diameters[k]),
                        engine_order_tracking(map, nodal_diameters[k], engine_orders)});
  return tracking_figure(frame, "engine_order_tracking", panels, numbered("EO", engine_orders));
}

}  // namespace tiprub::postprocess
