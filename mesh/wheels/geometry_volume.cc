// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/wheels/geometry_volume.h"

#include <cmath>
#include <functional>

#include "mesh/curves/gauss_points.h"

namespace tiprub {

namespace {

constexpr int panels_in_height = 4;
constexpr int least_panels_along = 80;    // many, since the curvature of tables may jump between two stations
constexpr double difference_step = 1e-5;  // of the unit square; central differences are then good to 1e-10

using Section = std::function<MeridionalPoint(double station, double height)>;
using Angle = std::function<double(double station, double height)>;

double area_density(const Section& section, double station, double height) {
  const double h = difference_step;
  const MeridionalPoint along = section(station + h, height) - section(station - h, height);
  const MeridionalPoint up = section(station, height + h) - section(station, height - h);
  return std::abs(along.z * up.r - along.r * up.z) / (4.0 * h * h);
}

// The integral of r * angle over the part of the section between two stations.
double slice_volume(const Section& section, const Angle& angle, double from, double to) {
  double volume = 0.0;
  for (const GaussPoint& a : gauss_5)
    for (int panel = 0; panel < panels_in_height; ++panel)
      for (const GaussPoint& b : gauss_5) {
        const double station = 0.5 * (from + to) + 0.5 * (to - from) * a.x;
        const double height = (panel + 0.5 * (1.0 + b.x)) / panels_in_height;
        volume += 0.25 * (to - from) / panels_in_height * a.weight * b.weight * section(station, height).r *
                  angle(station, height) * area_density(section, station, height);
      }
  return volume;
}

double volume_between(const SectorPlan& plan, int first_station, const Section& section, const Angle& angle) {
  const int panels = 1 + least_panels_along / plan.elements.chord;
  double volume = 0.0;
  for (int i = first_station; i < plan.elements.chord; ++i) {
    const double from = plan.station(2 * i), width = (plan.station(2 * i + 2) - from) / panels;
    for (int panel = 0; panel < panels; ++panel)
      volume += slice_volume(section, angle, from + panel * width, from + (panel + 1) * width);
  }
  return volume;
}

}  // namespace

double geometry_volume(const Wheel& wheel) {
  const WheelGeometry& geometry = *wheel.geometry;
  const SectorPlan& plan = wheel.plan;
  const Section disc = [&](double station, double height) { return geometry.disc_point(station, height); };
  const Section blade = [&](double station, double span) { return geometry.blade_point(station, span); };
  const auto width = [&](BladeKind kind) -> Angle {
    return [&geometry, kind](double station, double span) { return 2.0 * geometry.half_width(kind, station, span); };
  };
  double volume = 0.0;
  if (plan.has_disc()) volume += volume_between(plan, 0, disc, [&](double, double) { return plan.pitch(); });
  if (plan.blades != Blades::none) volume += volume_between(plan, 0, blade, width(BladeKind::main));
  if (plan.blades == Blades::main_and_splitter)
    volume += volume_between(plan, plan.elements.upstream, blade, width(BladeKind::splitter));
  return volume;
}

}  // namespace tiprub
