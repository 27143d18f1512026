// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/wheels/wheel.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "cases/program/text.h"
#include "mesh/curves/smooth_table.h"

namespace tiprub::mesh {

namespace {

constexpr int fewest_sectors = 3;  // so that a sector and its two neighbours are different sectors
constexpr int most_sectors = 1000;

// The blades are checked without their fillets first, so that a fillet is at fault if they cross only with it.
const char* key_of_width(const CaseTable& table, const SectorPlan& plan, double span) {
  if (plan.elements.fillet > 0) return "fillet_radius";
  if (table.has("blade_file")) return "blade_file";
  return span < 0.5 ? "thickness_root" : "thickness_tip";
}

struct Place {
  double station, span;
};

[[noreturn]] void refuse_width(const CaseTable& table, const SectorPlan& plan, const Place& at, double width,
                               double room) {
  table.reject(key_of_width(table, plan, at.span),
               text_of("makes blades cross: at ", at.station, " of the meridional length and ", at.span,
                       " of the way from hub to tip they take ", width, " rad of the circle, and have ", room,
                       " rad; make the blade or its fillet thinner, or its angle smaller"));
}

// At the hub the columns of a splitter also exist upstream of it.
bool splitter_is_at(const SectorPlan& plan, const Place& at) {
  return plan.blades == Blades::main_and_splitter && (at.span == 0.0 || at.station >= plan.splitter_start);
}

// Neighbours must not meet in the narrower of the two passages; at the hub neither may reach the sector's cut, which
// halves the passage behind the splitter.
void check_widths_at(const CaseTable& table, const Wheel& wheel, const Place& at) {
  const SectorPlan& plan = wheel.plan;
  const bool has_splitter = splitter_is_at(plan, at);
  const double main = wheel.geometry->half_width(BladeKind::main, at.station, at.span);
  const double neighbour = has_splitter ? wheel.geometry->half_width(BladeKind::splitter, at.station, at.span) : main;
  const double passage = has_splitter ? 1.0 - plan.splitter_pitch : 1.0;
  const double narrower = has_splitter ? std::min(plan.splitter_pitch, passage) : 1.0;
  if (main + neighbour >= narrower * plan.pitch())
    refuse_width(table, plan, at, main + neighbour, narrower * plan.pitch());
  const double to_cut = 0.5 * passage * plan.pitch();
  if (at.span == 0.0 && std::max(main, neighbour) >= to_cut)
    refuse_width(table, plan, at, std::max(main, neighbour), to_cut);
}

void check_widths(const CaseTable& table, const Wheel& wheel) {
  const SectorPlan& plan = wheel.plan;
  for (int half = 0; half <= 2 * plan.elements.chord; ++half) {
    const double station = plan.station(half), fillet_end = wheel.geometry->fillet_end(station);
    for (int layer = 0; layer <= 2 * plan.elements.span; ++layer)
      check_widths_at(table, wheel, {station, plan.span(layer, fillet_end)});
  }
}

// The key is also read for a wheel without splitters, so that the message can say what is wrong.
void read_contact_blades(CaseTable& table, SectorPlan& plan) {
  const bool has_splitter = plan.blades == Blades::main_and_splitter;
  if (!has_splitter && !table.has("contact_blades")) return;
  plan.contact_on_splitters = table.choice("contact_blades", false, {{false, "main"}, {true, "both"}});
  if (plan.contact_on_splitters && !has_splitter)
    table.reject("contact_blades",
                 "= \"both\" asks for contact on splitters, and this wheel has none; take \"main\"");
}

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
    table.reject("fillet_radius", text_of("= ", radius, " must be less than the blade's height, ", height, " m at ",
                                          station, " of the meridional length"));
  }
}

/// Reads `fillet_radius`, and gives the wheel that fillet where the hub meets either flank of its blades: at height h
/// above the hub, along the span, a flank stands out by radius - sqrt(h (2 radius - h)) across the blade, a quarter
/// of a circle that leaves the flank smoothly and runs out on the hub. With radius 0 the wheel is returned as it is.
/// The family's part of the plan must be known. Raises InputError.
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

}  // namespace

Wheel read_wheel(CaseTable& table) {
  Wheel wheel;
  const auto read_family = table.choice<decltype(&read_impeller)>(
      "family", std::nullopt,
      {{read_impeller, "impeller"}, {read_bladed_disc, "bladed_disc"}, {read_wheel_of_blade_file, "blade_file"}});
  wheel.plan.sector_count =
      table.integer("blade_count", std::nullopt, Range::between(fewest_sectors, most_sectors), "sectors");
  wheel.geometry = read_family(table, wheel.plan);
  read_contact_blades(table, wheel.plan);
  if (wheel.plan.blades != Blades::none) {
    check_widths(table, wheel);
    if (wheel.plan.has_disc()) wheel.geometry = read_root_fillet(table, wheel.plan, std::move(wheel.geometry));
    check_widths(table, wheel);
  }
  table.close();
  return wheel;
}

}  // namespace tiprub::mesh
