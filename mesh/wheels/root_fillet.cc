// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/wheels/root_fillet.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <sstream>

#include "mesh/curves/wheel_keys.h"

namespace tiprub {

namespace {

constexpr double slope_step = 1e-6;  // of the meridional length, for the blade's angle
constexpr int usual_elements = 2;

class WheelWithFillet final : public WheelGeometry {
 public:
  WheelWithFillet(std::unique_ptr<WheelGeometry> wheel, double radius) : wheel_(std::move(wheel)), radius_(radius) {}

  MeridionalPoint disc_point(double station, double height) const override {
    return wheel_->disc_point(station, height);
  }
  MeridionalPoint blade_point(double station, double span) const override {
    return wheel_->blade_point(station, span);
  }
  double theta(double station, double span) const override { return wheel_->theta(station, span); }
  double half_width(BladeKind blade, double station, double span) const override {
    return wheel_->half_width(blade, station, span) + widening(station, span);
  }
  double fillet_end(double station) const override {
    const auto beyond = [&](double span) { return height(station, span) - radius_; };
    std::uintmax_t steps = 100;
    const auto [low, high] =
        boost::math::tools::toms748_solve(beyond, 0.0, 1.0, boost::math::tools::eps_tolerance<double>(), steps);
    return 0.5 * (low + high);
  }
  std::string keys_that_shape(Region region) const override {
    return wheel_->keys_that_shape(region) + ", fillet_radius";
  }

  double height(double station, double span) const {
    return distance(wheel_->blade_point(station, 0.0), wheel_->blade_point(station, span));
  }

 private:
  double widening(double station, double span) const {
    const double h = height(station, span);
    if (h >= radius_) return 0.0;
    const double across = radius_ - std::sqrt(h * (2.0 * radius_ - h));
    return across / (wheel_->blade_point(station, span).r * cos_angle(station, span));
  }
  // The cosine of the angle between the blade and the meridional plane. A width across the blade, divided by it, is
  // the width along the circle.
  double cos_angle(double station, double span) const {
    const double from = std::max(0.0, station - slope_step), to = std::min(1.0, station + slope_step);
    const double along = distance(wheel_->blade_point(from, span), wheel_->blade_point(to, span));
    const double turn = wheel_->theta(to, span) - wheel_->theta(from, span);
    return along / std::hypot(along, wheel_->blade_point(station, span).r * turn);
  }

  std::unique_ptr<WheelGeometry> wheel_;
  double radius_;
};

void check_height(const CaseTable& table, const SectorPlan& plan, const WheelWithFillet& wheel, double radius) {
  for (int half = 0; half <= 2 * plan.elements.chord; ++half) {
    const double station = plan.station(half), height = wheel.height(station, 1.0);
    if (radius < height) continue;
    std::ostringstream message;
    message << "= " << radius << " must be less than the blade's height, " << height << " m at " << station
            << " of the meridional length";
    table.reject("fillet_radius", message.str());
  }
}

}  // namespace

std::unique_ptr<WheelGeometry> read_root_fillet(CaseTable& table, SectorPlan& plan,
                                                std::unique_ptr<WheelGeometry> wheel) {
  const double radius = table.number("fillet_radius", 0.0, Range::between(0.0, wheel_length.high), "m");
  if (radius == 0.0) return wheel;
  auto rounded = std::make_unique<WheelWithFillet>(std::move(wheel), radius);
  check_height(table, plan, *rounded, radius);
  const int most = plan.elements.span - 1;
  if (most < 1) table.reject("elements_along_span", "must be at least 2 with a fillet, which takes one of them");
  plan.elements.fillet =
      table.integer("elements_along_fillet", std::min(usual_elements, most), Range::between(1, most), "elements");
  return rounded;
}

}  // namespace tiprub
