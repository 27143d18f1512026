// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scene/casing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cases/program/text.h"
#include "cases/program/units.h"
#include "simulate/scene/damping.h"
#include "simulate/scene/simulate_parameters.h"

namespace tiprub::simulate {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// Angles in radians cover less than a fiftieth of a lobe that is counted in degrees.
void require_degrees(const CaseTable& table, const Casing& casing, const std::vector<std::array<double, 2>>& points) {
  constexpr double least_share = 0.02;
  const double period = 360.0 / casing.lobes, first = points.front()[0], last = points.back()[0];
  if (casing.unusual || last - first >= least_share * period) return;
  table.reject("distortion_table",
               text_of("has its angles from ", first, " to ", last, " deg, less than a fiftieth of the ", period,
                       " deg of a lobe; are they in radians? If they are meant, add unusual = true to this table"),
               points.size() - 1);
}

void read_distortion_table(CaseTable& table, Casing& casing) {
  auto points = table.points("distortion_table", std::nullopt, Range::any(), "deg, m inward");
  const double period = 360.0 / casing.lobes;
  const bool too_low = points.front()[0] < 0;
  if (too_low || points.back()[0] >= period)
    table.reject("distortion_table",
                 "must have its angles in 0 .. 360/lobes deg, that end excluded; it repeats `lobes` times",
                 too_low ? 0 : points.size() - 1);
  const auto nearer = [&](const auto& one, const auto& next) {
    return next[0] - one[0] <= PeriodicTable::closest * period;
  };
  if (const auto near = std::ranges::adjacent_find(points, nearer); near != points.end())
    table.reject("distortion_table", "must have its angles more than 1e-9 of 360/lobes deg apart",
                 near - points.begin() + 1);
  if (points.size() > 1) require_degrees(table, casing, points);
  for (auto& [angle, inward] : points) angle *= radians_per_degree;
  const auto crest = std::ranges::max_element(points, {}, [](const auto& point) { return std::abs(point[1]); });
  casing.amplitude = std::abs((*crest)[1]);
  casing.crest_row = crest - points.begin();
  casing.table = PeriodicTable(points, period * radians_per_degree);
}

void read_shape(CaseTable& table, Casing& casing) {
  casing.shape = table.choice("shape", CasingShape::cosine,
                              {{CasingShape::cosine, "cosine"},
                               {CasingShape::bumps, "bumps"},
                               {CasingShape::table, "table"},
                               {CasingShape::profile, "profile"}});
  casing.lobes = table.integer("lobes", 2, Range::between(1, 1000), "lobes around the casing");
  casing.unusual = table.flag("unusual", false);
  if (casing.shape == CasingShape::table) {
    read_distortion_table(table, casing);
  } else if (casing.shape == CasingShape::profile) {
    const NamedText file = table.file("profile", "a casing's profile");
    casing.profile_file = file.name;
    casing.profile = read_casing_profile(file, two_pi / casing.lobes);
    casing.amplitude = casing.profile.largest();
  } else {
    casing.amplitude = table.number("amplitude", std::nullopt, Range::at_least(0), "m inward at the crest");
  }
  if (casing.shape != CasingShape::bumps) {
    table.only_with("bump_width_deg", "shape = \"bumps\"");
    return;
  }
  const double width =
      table.number("bump_width_deg", 20.0, {0.0, 360.0 / casing.lobes, Range::LowEnd::excluded}, "deg");
  if (!casing.unusual) require_usual(table, "bump_width_deg", width, Range::at_least(1), "deg");
  casing.bump_width = radians_per_degree * width;
}

std::vector<std::array<double, 2>> points_over_chord(CaseTable& table, const char* key, const std::string& unit) {
  auto points = table.points(key, std::nullopt, Range::at_least(0), "fraction of the chord, " + unit);
  const bool too_low = points.front()[0] < 0;
  if (too_low || points.back()[0] > 1)
    table.reject(key, "must have its fractions of the arc length in 0 .. 1", too_low ? 0 : points.size() - 1);
  return points;
}

void read_friction(CaseTable& table, Casing& casing) {
  const char* const key = "friction_coefficient";
  const std::string unit = "of the contact force";
  if (table.is_one_number(key))
    casing.friction = {{0.0, table.number(key, 0.0, Range::at_least(0), unit + "; 0: none")}};
  else
    casing.friction = points_over_chord(table, key, unit);
  if (casing.unusual) return;
  for (const auto& [place, coefficient] : casing.friction)
    require_usual(table, key, coefficient, Range::between(0, 1), unit);
}

/// The smallest of the numbers is moved into `clearance`.
void read_blade_clearance(CaseTable& table, Casing& casing) {
  if (!table.has("blade_clearance")) return;
  casing.blade_clearance = table.numbers("blade_clearance", std::nullopt, Range::any(), "m more, blade by blade");
  const auto closest = std::ranges::min_element(casing.blade_clearance);
  const std::size_t row = closest - casing.blade_clearance.begin();
  const double least = *closest;
  for (double& more : casing.blade_clearance) more -= least;
  for (std::array<double, 2>& point : casing.clearance) point[1] += least;
  if (std::ranges::any_of(casing.clearance, [](const auto& point) { return point[1] < 0; }))
    table.reject("blade_clearance", "takes more from `clearance` than there is", row);
}

const char* key_of_shape(CasingShape shape) {
  if (shape == CasingShape::table) return "distortion_table";
  return shape == CasingShape::profile ? "profile" : "amplitude";
}

}  // namespace

double Casing::distortion(double angle, double fraction) const {
  const double period = two_pi / lobes;  // eq. 16: f = N_l Omega for an angle that grows with Omega t
  const double turned = angle - crest_angle;
  const double from_crest = turned - period * std::round(turned / period);
  switch (shape) {
    case CasingShape::cosine:
      return amplitude * std::cos(lobes * from_crest);
    case CasingShape::bumps:
      return std::abs(from_crest) >= bump_width / 2
                 ? 0.0
                 : amplitude * std::pow(std::cos(std::numbers::pi * from_crest / bump_width), 2);
    case CasingShape::table:
      return table(turned);
    case CasingShape::profile:
      return profile(turned, fraction);
  }
  return 0.0;
}

double Casing::ramp(double revolutions) const {
  const double x = std::clamp(revolutions / ramp_revolutions, 0.0, 1.0);
  return x * x * x * (10 - 15 * x + 6 * x * x);
}

Eigen::VectorXd Casing::friction_at(const ContactLine& contact) const {
  return arc_fractions(contact).unaryExpr([&](double fraction) { return linear_between(friction, fraction); });
}

bool Casing::has_friction() const {
  return std::ranges::any_of(friction, [](const auto& point) { return point[1] > 0; });
}

std::string Casing::friction_text() const {
  const auto [least, most] = std::ranges::minmax_element(friction, {}, [](const auto& point) { return point[1]; });
  if ((*most)[1] > (*least)[1]) return text_of((*least)[1], " .. ", (*most)[1], " over the chord");
  return text_of((*least)[1]);
}

Eigen::VectorXd Casing::given_clearance(const ContactLine& contact) const {
  return arc_fractions(contact).unaryExpr([&](double fraction) { return linear_between(clearance, fraction); });
}

Eigen::VectorXd Casing::crests(const ContactLine& contact) const {
  constexpr int points = 3600;  // of a turn that begins at a crest
  const Eigen::VectorXd fractions = arc_fractions(contact);
  Eigen::VectorXd highest = Eigen::VectorXd::Constant(fractions.size(), -std::numeric_limits<double>::infinity());
  for (int point = 0; point < points; ++point)
    for (Eigen::Index node = 0; node < fractions.size(); ++node)
      highest[node] = std::max(highest[node], distortion(crest_angle + two_pi * point / points, fractions[node]));
  return highest;
}

Eigen::VectorXd Casing::running_clearance(const ContactLine& contact, double speed) const {
  const Eigen::VectorXd given = given_clearance(contact);
  if (clearance_state == ClearanceState::running) return given;
  const double from = clearance_state == ClearanceState::cold ? 0.0 : clearance_speed;
  const Eigen::MatrixX3d shift = contact.static_shift(speed) - contact.static_shift(from);
  return given - contact.normal.cwiseProduct(shift).rowwise().sum();
}

Eigen::VectorXd arc_fractions(const ContactLine& contact) {
  const Eigen::VectorXd from_start = contact.arc_length.array() - contact.arc_length[0];
  const double length = from_start[contact.trailing_edge()];
  return length > 0 ? Eigen::VectorXd(from_start / length) : Eigen::VectorXd::Zero(from_start.size());
}

Casing read_casing(CaseTable& table) {
  Casing casing;
  read_shape(table, casing);
  casing.crest_angle = radians_per_degree * table.number("crest_angle_deg", 0.0, Range::between(-360, 360), "deg");
  casing.ramp_revolutions = table.number("ramp_revolutions", 3.0, {0.0, 1e6, Range::LowEnd::excluded}, "revolutions");
  casing.clearance_state = table.choice("clearance_state", ClearanceState::running, clearance_state_names);
  if (casing.clearance_state == ClearanceState::at_speed)
    casing.clearance_speed =
        rad_s_per_rpm * table.number("clearance_speed_rpm", std::nullopt, Range::at_least(0), "rev/min");
  else
    table.only_with("clearance_speed_rpm", "clearance_state = \"at_speed\"");
  casing.clearance = points_over_chord(table, "clearance", "m");
  read_blade_clearance(table, casing);
  read_friction(table, casing);
  table.close();
  return casing;
}

void require_blades_of_wheel(const CaseTable& table, const Casing& casing, const SimulateParameters& parameters,
                             int sector_count) {
  if (casing.blade_clearance.empty()) return;
  const std::string key = "blade_clearance";
  if (casing.blade_clearance.size() != static_cast<std::size_t>(sector_count))
    table.reject(key, "has " + std::to_string(casing.blade_clearance.size()) + " numbers, and the wheel has " +
                          std::to_string(sector_count) + " blades; give one for each");
  if (parameters.nodal_diameters != DiameterChoice::all)
    table.reject(key, "makes the sectors differ; set [simulate] nodal_diameters = \"all\"");
  if (parameters.steady_state == SteadyStateMethod::orbit || parameters.branches != BranchChoice::none)
    table.reject(key,
                 "leaves no motion that is the same in all sectors; set [simulate] steady_state = \"march\" and "
                 "branches = \"none\"");
}

void require_ramp_within(const CaseTable& table, const Casing& casing, const SimulateParameters& parameters) {
  const int left = parameters.max_revolutions - parameters.recorded_revolutions;
  if (casing.ramp_revolutions <= left) return;
  table.reject("ramp_revolutions",
               text_of("= ", casing.ramp_revolutions, " is more than the ", left,
                       " revolutions that [simulate] max_revolutions leaves before the recording; lower it"));
}

void require_lengths_in_metres(const CaseTable& table, const Casing& casing, const ContactLine& contact) {
  const double radius = contact.position.col(0).maxCoeff(), largest_share = casing.unusual ? 0.1 : 0.02;
  const auto require = [&](const std::string& key, double length, std::optional<std::size_t> row = {}) {
    if (length <= largest_share * radius) return;
    const std::string text = text_of("has ", length, " m, more than a ", casing.unusual ? "tenth" : "fiftieth",
                                     " of the tip's radius of ", radius, " m; it is in metres, not in millimetres",
                                     casing.unusual ? "" : ". If it is meant, add unusual = true to this table");
    if (key == key_of_shape(CasingShape::profile))
      throw InputError(casing.profile_file + ": [casing] profile " + text);
    table.reject(key, text, row);
  };
  require(key_of_shape(casing.shape), casing.amplitude, casing.crest_row);
  for (std::size_t i = 0; i < casing.clearance.size(); ++i) require("clearance", casing.clearance[i][1], i);
  for (std::size_t i = 0; i < casing.blade_clearance.size(); ++i)
    require("blade_clearance", casing.blade_clearance[i], i);
}

}  // namespace tiprub::simulate
