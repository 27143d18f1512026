// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/wheels/impeller.h"

#include <algorithm>
#include <cmath>

#include "cases/program/units.h"
#include "mesh/wheels/wheel.h"

namespace tiprub::mesh {

namespace {

/// A centrifugal impeller, by the dimensions that its designers use. The hub's leading edge is at z = 0, the flow
/// turns from the axis to the radius, the back face lies on the side of larger z. The angle beta lies between the
/// blade and the meridional plane, positive where the blade turns towards +theta on its way to the trailing edge.
struct ImpellerParameters {
  double inlet_hub_radius;         ///< [m]
  double inlet_tip_radius;         ///< [m]
  double exit_radius;              ///< [m]
  double exit_tip_width;           ///< blade height at the exit [m]
  double axial_length;             ///< of the hub, from leading edge to exit [m]
  std::array<double, 2> hub_arms;  ///< of the hub's Bezier curve, see MeridionalCurve
  std::array<double, 2> tip_arms;
  SmoothTable hub_angle;       ///< beta over the fraction of the hub's length [rad]
  SmoothTable tip_angle;       ///< beta over the fraction of the tip's length [rad]
  double tip_lean;             ///< theta of the tip's leading edge minus the hub's [rad]
  SmoothTable thickness_root;  ///< over a blade's own chord [m]
  SmoothTable thickness_tip;
  double bore_radius;        ///< [m]
  SmoothTable back_profile;  ///< z of the back face over the radius [m]
};

constexpr double usual_bore_share = 0.45;  // of the stations that stand on the bore

constexpr double steepest_angle_deg = 80.0;
constexpr double quarter_ellipse_arm = 0.5523;

std::array<double, 2> read_arms(CaseTable& table, const char* key) {
  const std::vector<double> arms = table.numbers(key, std::vector<double>{quarter_ellipse_arm, quarter_ellipse_arm},
                                                 Range::between(0.05, 1.0), "");
  if (arms.size() != 2) table.reject(key, "must hold two numbers: the arm at the inlet and the arm at the exit");
  return {arms[0], arms[1]};
}

SmoothTable read_angles(CaseTable& table, const char* key) {
  return read_chord_table(table, key, std::nullopt, Range::between(-steepest_angle_deg, steepest_angle_deg), "deg",
                          radians_per_degree);
}

void read_splitter(CaseTable& table, SectorPlan& plan) {
  plan.blades = table.flag("splitter", true) ? Blades::main_and_splitter : Blades::main;
  if (plan.blades != Blades::main_and_splitter) return;
  plan.splitter_start = table.number("splitter_start", 0.4, Range::between(0.05, 0.95), "of the meridional length");
  plan.splitter_pitch = table.number("splitter_pitch", 0.5, Range::between(0.2, 0.8), "of the main blades' pitch");
}

void check_channel(const CaseTable& table, const ImpellerParameters& p) {
  if (p.bore_radius >= p.inlet_hub_radius)
    table.reject("bore_radius", "must be less than inlet_hub_radius; make the bore smaller");
  if (p.inlet_tip_radius <= p.inlet_hub_radius)
    table.reject("inlet_tip_radius", "must be more than inlet_hub_radius; the blade has no height at the inlet");
  if (p.exit_radius <= p.inlet_tip_radius)
    table.reject("exit_radius", "must be more than inlet_tip_radius; a centrifugal wheel grows towards its exit");
  if (p.exit_tip_width >= p.axial_length)
    table.reject("exit_tip_width", "must be less than axial_length; else the tip curve runs backwards");
  if (p.back_profile.first_x() != p.bore_radius || p.back_profile.last_x() != p.exit_radius)
    table.reject("back_profile", "must go from bore_radius to exit_radius; mend its first or its last radius");
}

// d theta / d fraction = length tan(beta) / r
double wrap_rate(const MeridionalCurve& curve, const SmoothTable& angle, double fraction) {
  return curve.length() * std::tan(angle.at(fraction)) / curve.at(fraction).r;
}

RunningIntegral wrap(const MeridionalCurve& curve, const SmoothTable& angle) {
  return RunningIntegral([curve, angle](double fraction) { return wrap_rate(curve, angle, fraction); });
}

/// A blade's mid-thickness surface lies between two flow lines: theta along either is the integral of tan(beta)/r
/// over the length; between hub and tip z, r and theta are linear in the span.
class Impeller final : public WheelGeometry {
 public:
  Impeller(const ImpellerParameters& parameters, const SectorPlan& plan)
      : parameters_(parameters),
        plan_(plan),
        back_{0.0, parameters.bore_radius, parameters.exit_radius, parameters.back_profile,
              plan.station(2 * plan.elements.bore)},
        hub_({0.0, parameters.inlet_hub_radius}, {parameters.axial_length, parameters.exit_radius},
             parameters.hub_arms),
        tip_({0.0, parameters.inlet_tip_radius},
             {parameters.axial_length - parameters.exit_tip_width, parameters.exit_radius}, parameters.tip_arms),
        wrap_hub_(wrap(hub_, parameters.hub_angle)),
        wrap_tip_(wrap(tip_, parameters.tip_angle)) {}

  MeridionalPoint disc_point(double station, double height) const override {
    return (1.0 - height) * back_.foot(station) + height * hub_.at(station);
  }
  MeridionalPoint blade_point(double station, double span) const override {
    return (1.0 - span) * hub_.at(station) + span * tip_.at(station);
  }
  double theta(double station, double span) const override {
    return (1.0 - span) * wrap_hub_.at(station) + span * (wrap_tip_.at(station) + parameters_.tip_lean);
  }
  double half_width(BladeKind blade, double station, double span) const override {
    const double chord = blade == BladeKind::main ? station : plan_.splitter_chord(station);
    const double thickness =
        (1.0 - span) * parameters_.thickness_root.at(chord) + span * parameters_.thickness_tip.at(chord);
    return 0.5 * thickness / (blade_point(station, span).r * cos_angle(station, span));
  }
  std::string keys_that_shape(Region region) const override {
    if (region == Region::disc) return "back_profile, elements_along_bore, hub_arms, hub_angle_deg, thickness_root";
    return "tip_angle_deg, hub_angle_deg, tip_lean_deg, tip_arms, thickness_root, thickness_tip";
  }

 private:
  /// cos(beta) of the flow line at this span: thickness over it is the width along the circumference.
  double cos_angle(double station, double span) const {
    const double theta_rate = (1.0 - span) * wrap_rate(hub_, parameters_.hub_angle, station) +
                              span * wrap_rate(tip_, parameters_.tip_angle, station);
    const MeridionalPoint along =
        (1.0 - span) * hub_.length() * hub_.unit_tangent(station) + span * tip_.length() * tip_.unit_tangent(station);
    const double meridional_rate = std::hypot(along.z, along.r);
    return meridional_rate / std::hypot(meridional_rate, blade_point(station, span).r * theta_rate);
  }

  ImpellerParameters parameters_;
  SectorPlan plan_;
  BackFace back_;
  MeridionalCurve hub_;
  MeridionalCurve tip_;
  RunningIntegral wrap_hub_;
  RunningIntegral wrap_tip_;
};

}  // namespace

MeridionalPoint BackFace::foot(double station) const {
  if (station <= bore_end) return {front_z + (profile.at(bore_radius) - front_z) * station / bore_end, bore_radius};
  const double radius = bore_radius + (exit_radius - bore_radius) * (station - bore_end) / (1.0 - bore_end);
  return {profile.at(radius), radius};
}

SmoothTable read_back_profile(CaseTable& table) {
  return SmoothTable(
      table.points("back_profile", std::nullopt, Range::between(-wheel_length.high, wheel_length.high), "m"));
}

void read_bore_elements(CaseTable& table, SectorPlan& plan) {
  const int usual = std::max(1, static_cast<int>(usual_bore_share * plan.elements.chord));
  plan.elements.bore =
      table.integer("elements_along_bore", usual, Range::between(1, plan.elements.chord - 1), "elements");
}

std::unique_ptr<WheelGeometry> read_impeller(CaseTable& table, SectorPlan& plan) {
  const auto size = [&](const char* key) { return table.number(key, std::nullopt, wheel_length, "m"); };
  const auto thickness = [&](const char* key) {
    return read_chord_table(table, key, std::nullopt, wheel_length, "m");
  };
  const double inlet_hub = size("inlet_hub_radius"), inlet_tip = size("inlet_tip_radius");
  const double exit = size("exit_radius"), width = size("exit_tip_width"), length = size("axial_length");
  const auto hub_arms = read_arms(table, "hub_arms"), tip_arms = read_arms(table, "tip_arms");
  const SmoothTable hub_angle = read_angles(table, "hub_angle_deg"), tip_angle = read_angles(table, "tip_angle_deg");
  const double lean = radians_per_degree * table.number("tip_lean_deg", 0.0, Range::between(-45.0, 45.0), "deg");
  const SmoothTable root = thickness("thickness_root"), tip = thickness("thickness_tip");
  const double bore = size("bore_radius");
  const SmoothTable back = read_back_profile(table);
  const ImpellerParameters parameters{inlet_hub, inlet_tip, exit, width, length, hub_arms, tip_arms,
                                      hub_angle, tip_angle, lean, root,  tip,    bore,     back};
  check_channel(table, parameters);
  read_splitter(table, plan);
  read_common(table, plan, BackFace::fewest_stations);
  read_bore_elements(table, plan);
  return std::make_unique<Impeller>(parameters, plan);
}

}  // namespace tiprub::mesh
