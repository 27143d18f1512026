// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scene/casing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "cases/program/units.h"
#include "simulate/scene/linear_between.h"

namespace tiprub {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double radians = std::numbers::pi / 180;

void read_distortion_table(CaseTable& table, Casing& casing) {
  auto points = table.points("distortion_table", std::nullopt, Range::any(), "deg, m inward");
  const double period = 360.0 / casing.lobes;
  if (points.front()[0] < 0 || points.back()[0] >= period)
    table.reject("distortion_table",
                 "must have its angles in 0 .. 360/lobes deg, that end excluded; it repeats `lobes` times");
  for (auto& [angle, inward] : points) {
    angle *= radians;
    casing.amplitude = std::max(casing.amplitude, std::abs(inward));
  }
  casing.table = PeriodicTable(points, period * radians);
}

}  // namespace

double Casing::distortion(double angle) const {
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
  }
  return 0.0;
}

double Casing::ramp(double revolutions) const {
  const double x = std::clamp(revolutions / ramp_revolutions, 0.0, 1.0);
  return x * x * x * (10 - 15 * x + 6 * x * x);
}

Eigen::VectorXd Casing::given_clearance(const ContactLine& contact) const {
  const Eigen::Index count = contact.arc_length.size();
  const double start = contact.arc_length[0];
  const double length = contact.arc_length[count - 1] - start;
  Eigen::VectorXd values(count);
  for (Eigen::Index k = 0; k < count; ++k)
    values[k] = linear_between(clearance, length > 0 ? (contact.arc_length[k] - start) / length : 0.0);
  return values;
}

Eigen::VectorXd Casing::running_clearance(const ContactLine& contact, double speed) const {
  const Eigen::VectorXd given = given_clearance(contact);
  if (clearance_state == ClearanceState::running) return given;
  const double from = clearance_state == ClearanceState::cold ? 0.0 : clearance_speed;
  const Eigen::MatrixX3d shift = contact.static_shift(speed) - contact.static_shift(from);
  return given - contact.normal.cwiseProduct(shift).rowwise().sum();
}

Casing read_casing(CaseTable& table) {
  Casing casing;
  casing.shape = table.choice<CasingShape>(
      "shape", CasingShape::cosine,
      {{"cosine", CasingShape::cosine}, {"bumps", CasingShape::bumps}, {"table", CasingShape::table}});
  casing.lobes = table.integer("lobes", 2, Range::between(1, 1000), "lobes around the casing");
  if (casing.shape == CasingShape::table) {
    read_distortion_table(table, casing);
  } else {
    casing.amplitude = table.number("amplitude", std::nullopt, Range::at_least(0), "m inward at the crest");
  }
  if (casing.shape == CasingShape::bumps)
    casing.bump_width =
        radians * table.number("bump_width_deg", 20.0, {0.0, 360.0 / casing.lobes, Range::LowEnd::excluded}, "deg");
  casing.crest_angle = radians * table.number("crest_angle_deg", 0.0, Range::between(-360, 360), "deg");
  casing.ramp_revolutions = table.number("ramp_revolutions", 3.0, {0.0, 1e6, Range::LowEnd::excluded}, "revolutions");
  casing.clearance_state = table.choice<ClearanceState>(
      "clearance_state", ClearanceState::running,
      {{"cold", ClearanceState::cold}, {"running", ClearanceState::running}, {"at_speed", ClearanceState::at_speed}});
  if (casing.clearance_state == ClearanceState::at_speed)
    casing.clearance_speed =
        rad_s_per_rpm * table.number("clearance_speed_rpm", std::nullopt, Range::at_least(0), "rev/min");
  casing.clearance = table.points("clearance", std::nullopt, Range::at_least(0), "fraction of the chord, m");
  if (casing.clearance.front()[0] < 0 || casing.clearance.back()[0] > 1)
    table.reject("clearance", "must have its fractions of the arc length in 0 .. 1");
  table.close();
  return casing;
}

void require_lengths_in_metres(const CaseTable& table, const Casing& casing, const ContactLine& contact) {
  constexpr double largest_share = 0.1;
  const double radius = contact.position.col(0).maxCoeff();
  const auto require = [&](const char* key, double length) {
    if (length <= largest_share * radius) return;
    std::ostringstream text;
    text << "has " << length << " m, more than a tenth of the tip's radius of " << radius
         << " m; it is in metres, not in millimetres";
    table.reject(key, text.str());
  };
  require(casing.shape == CasingShape::table ? "distortion_table" : "amplitude", casing.amplitude);
  for (const std::array<double, 2>& point : casing.clearance) require("clearance", point[1]);
}

}  // namespace tiprub
