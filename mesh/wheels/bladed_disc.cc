// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "cases/program/units.h"
#include "mesh/curves/smooth_table.h"
#include "mesh/wheels/wheel.h"

namespace tiprub::mesh {

namespace {

/// An annular disc, with axial blades on its rim or bare. The rim's middle is at z = 0, the leading edge at
/// z = -axial_length / 2.
struct BladedDisc final : WheelGeometry {
  double bore_radius = 0;                    ///< [m]
  double rim_radius = 0;                     ///< [m]
  double axial_length = 0;                   ///< of the rim and of the blades [m]
  SmoothTable disc_profile{{{0.0, 0.0}}};    ///< the disc's axial thickness over the radius [m]
  double tip_radius = 0;                     ///< [m]; the rim's without blades
  double stagger_root = 0;                   ///< between blade and axis, positive towards +theta downstream [rad]
  double stagger_tip = 0;                    ///< [rad]; the root's for a straight blade
  SmoothTable thickness_root{{{0.0, 0.0}}};  ///< over the chord [m]
  SmoothTable thickness_tip{{{0.0, 0.0}}};

  MeridionalPoint disc_point(double station, double height) const override {
    const double radius = (1.0 - height) * bore_radius + height * rim_radius;
    return {(station - 0.5) * disc_profile.at(radius), radius};
  }
  MeridionalPoint blade_point(double station, double span) const override {
    return {(station - 0.5) * axial_length, (1.0 - span) * rim_radius + span * tip_radius};
  }
  double theta(double station, double span) const override {
    const MeridionalPoint at = blade_point(station, span);
    return at.z * std::tan(stagger(span)) / at.r;
  }
  double half_width(BladeKind, double station, double span) const override {
    const double thickness = (1.0 - span) * thickness_root.at(station) + span * thickness_tip.at(station);
    return 0.5 * thickness / (blade_point(station, span).r * std::cos(stagger(span)));
  }
  std::string keys_that_shape(Region region) const override {
    if (region == Region::disc) return "disc_profile, stagger_root_deg, thickness_root";
    return "stagger_root_deg, stagger_tip_deg, thickness_root, thickness_tip";
  }

  double stagger(double span) const { return (1.0 - span) * stagger_root + span * stagger_tip; }
};

constexpr double steepest_stagger_deg = 80.0;

SmoothTable read_disc_profile(CaseTable& table, const BladedDisc& p) {
  const std::vector<std::array<double, 2>> constant = {{p.bore_radius, p.axial_length},
                                                       {p.rim_radius, p.axial_length}};
  SmoothTable profile(table.points("disc_profile", constant, wheel_length, "m"));
  if (profile.first_x() != p.bore_radius || profile.last_x() != p.rim_radius ||
      profile.at(p.rim_radius) != p.axial_length)
    table.reject("disc_profile", "must go from bore_radius to rim_radius and end with axial_length; mend its ends");
  return profile;
}

void read_blade(CaseTable& table, BladedDisc& p) {
  const Range stagger = Range::between(-steepest_stagger_deg, steepest_stagger_deg);
  p.tip_radius = table.number("tip_radius", std::nullopt, wheel_length, "m");
  if (p.tip_radius <= p.rim_radius)
    table.reject("tip_radius", "must be more than rim_radius; the blade has no height");
  const double root_deg = table.number("stagger_root_deg", 0.0, stagger, "deg");
  p.stagger_root = radians_per_degree * root_deg;
  p.stagger_tip = radians_per_degree * table.number("stagger_tip_deg", root_deg, stagger, "deg");
  p.thickness_root = read_chord_table(table, "thickness_root", std::nullopt, wheel_length, "m");
  p.thickness_tip = read_chord_table(table, "thickness_tip", std::nullopt, wheel_length, "m");
}

}  // namespace

std::unique_ptr<WheelGeometry> read_bladed_disc(CaseTable& table, SectorPlan& plan) {
  const auto size = [&](const char* key) { return table.number(key, std::nullopt, wheel_length, "m"); };
  auto wheel = std::make_unique<BladedDisc>();
  wheel->bore_radius = size("bore_radius");
  wheel->rim_radius = wheel->tip_radius = size("rim_radius");
  wheel->axial_length = size("axial_length");
  if (wheel->rim_radius <= wheel->bore_radius) table.reject("rim_radius", "must be more than bore_radius");
  wheel->disc_profile = read_disc_profile(table, *wheel);
  plan.blades = table.choice("blade", Blades::main, {{Blades::main, "present"}, {Blades::none, "none"}});
  if (plan.blades == Blades::main) read_blade(table, *wheel);
  read_common(table, plan, 1);
  return wheel;
}

}  // namespace tiprub::mesh
