// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "cases/program/text.h"
#include "cases/program/units.h"
#include "mesh/blades/blade_files.h"
#include "mesh/blades/blade_section.h"
#include "mesh/curves/smooth_table.h"
#include "mesh/wheels/impeller.h"
#include "mesh/wheels/wheel.h"

namespace tiprub::mesh {

namespace {

constexpr double narrowest = 1e-3;  // width of a disc over the hub's radius
constexpr double printed = 1e-6;    // relative precision of a number that is copied from a printed table
constexpr double usual_blunt_edge = 0.01, widest_blunt_edge = 0.2;

FileBlade read_sections(CaseTable& table) {
  const NamedText file = table.file("blade_file", "a file of blade sections");
  const double length = read_length_unit(table);
  const double angle = table.choice("angle_unit", 1.0, {{1.0, "rad"}, {radians_per_degree, "deg"}});
  return read_section_table(file, {length, angle});
}

FileBlade read_curves(CaseTable& table) {
  const NamedText profiles = table.file("blade_file", "a profile.curve");
  const NamedText hub = table.file("hub_file", "a hub.curve"), shroud = table.file("shroud_file", "a shroud.curve");
  const double length = read_length_unit(table);
  const double clearance = table.number("tip_clearance", 0.0, Range::between(0.0, wheel_length.high), "m");
  const MeridionalPath hub_path = read_path_curve(hub, length), shroud_path = read_path_curve(shroud, length);
  return cut_to_path(read_profile_curve(profiles, length, hub_path), hub_path, shroud_path, clearance, profiles.name,
                     hub.name);
}

FileBlade read_meanlines(CaseTable& table) {
  const NamedText file = table.file("blade_file", "a meanline file (.rtzt)");
  return read_meanline(file, read_length_unit(table));
}

// A wheel that turns the other way about z is mirrored: ours turns towards +theta.
void turn_towards_positive(CaseTable& table, FileBlade& blade) {
  if (table.choice("rotation", true, {{true, "positive"}, {false, "negative"}})) return;
  const auto mirror = [](std::vector<BladeSection>& sections) {
    for (BladeSection& section : sections)
      for (BladePoint& point : section) point.theta = -point.theta;
  };
  mirror(blade.sections);
  if (!blade.splitter) return;
  mirror(blade.splitter->sections);
  blade.splitter->pitch_fraction = 1.0 - blade.splitter->pitch_fraction;
}

/// A disc whose faces close upon the blades' ends: its axial thickness over the fraction of the height from bore to
/// hub, relative to the blade's axial length at the hub.
struct DiscProfile {
  double bore_radius;
  SmoothTable relative_thickness;

  MeridionalPoint at(const MeridionalPoint& hub, double middle_z, double height) const {
    return {middle_z + (hub.z - middle_z) * relative_thickness.at(height),
            (1.0 - height) * bore_radius + height * hub.r};
  }
};

class BladesOfFile final : public WheelGeometry {
 public:
  explicit BladesOfFile(SectionSurface blade) : blade_(std::move(blade)) {}
  /// To be called before stand_on(), because the disc has the same stations.
  void add(const SplitterSurface& splitter, const SectorPlan& plan) {
    splitter_ = splitter;
    plan_ = plan;
  }
  void stand_on(DiscProfile profile) { profile_ = std::move(profile); }
  void stand_on(BackFace back) { back_ = std::move(back); }

  MeridionalPoint disc_point(double station, double height) const override {
    if (back_) return (1.0 - height) * back_->foot(station) + height * hub(station);
    return profile_->at(hub(station), 0.5 * (hub(0.0).z + hub(1.0).z), height);
  }
  MeridionalPoint blade_point(double station, double span) const override { return main(station, span).at; }
  double theta(double station, double span) const override { return main(station, span).theta; }
  double half_width(BladeKind blade, double station, double span) const override {
    if (blade == BladeKind::splitter) return splitter_->half_width(plan_.splitter_chord(station), span);
    return main(station, span).half_width;
  }
  std::string keys_that_shape(Region region) const override {
    if (region == Region::disc) return "disc_profile, back_profile, bore_radius, and the hub section of blade_file";
    return "blunt_edge, blade_file";
  }
  MeridionalPoint hub(double station) const { return main(station, 0.0).at; }

 private:
  BladePoint main(double station, double span) const {
    return blade_.at(splitter_ ? splitter_->main_chord(station, span) : station, span);
  }

  SectionSurface blade_;
  std::optional<SplitterSurface> splitter_;
  SectorPlan plan_;  ///< where there is a splitter
  std::optional<DiscProfile> profile_;
  std::optional<BackFace> back_;
};

double read_bore(CaseTable& table, const BladesOfFile& wheel) {
  const double bore = table.number("bore_radius", std::nullopt, wheel_length, "m");
  const double hub = std::min(wheel.hub(0.0).r, wheel.hub(1.0).r);
  if (bore < hub) return bore;
  table.reject("bore_radius", text_of("must be less than the hub's radius, ", hub, " m at its smaller end"));
}

/// What carries the blades: nothing, so that there is only the main one; an axial wheel's disc, by its thickness over
/// the height; or a radial wheel's, by its bore and the back face.
void stand_alone(CaseTable& table, SectorPlan& plan, BladesOfFile&) {
  read_common_of_blade(table, plan);
}

void stand_on_profile(CaseTable& table, SectorPlan& plan, BladesOfFile& wheel) {
  const double bore = read_bore(table, wheel);
  const double width = std::abs(wheel.hub(1.0).z - wheel.hub(0.0).z);
  if (width < narrowest * wheel.hub(1.0).r)
    table.reject("disc", "= \"profile\" needs a hub that is as wide as the disc; this one is radial: take back_face");
  auto points = table.points("disc_profile", {{{0.0, width}}}, wheel_length, "m");
  if (points.front()[0] != 0.0 || points.back()[0] >= 1.0)
    table.reject("disc_profile",
                 "must go from height 0, the bore, to less than 1, the hub, where the disc is as wide as the blade");
  for (auto& point : points) point[1] /= width;
  points.push_back({1.0, 1.0});
  wheel.stand_on(DiscProfile{bore, SmoothTable(std::move(points))});
  read_common(table, plan, 1);
}

void stand_on_back_face(CaseTable& table, SectorPlan& plan, BladesOfFile& wheel) {
  const double bore = read_bore(table, wheel), exit = wheel.hub(1.0).r;
  const SmoothTable back = read_back_profile(table);
  if (back.first_x() != bore || back.last_x() < (1.0 - printed) * exit) {
    table.reject("back_profile",
                 text_of("must go from bore_radius to the hub's radius at the exit, ", exit, " m, or beyond"));
  }
  read_common(table, plan, BackFace::fewest_stations);
  read_bore_elements(table, plan);
  wheel.stand_on(BackFace{wheel.hub(0.0).z, bore, exit, back, plan.station(2 * plan.elements.bore)});
}

void add_splitter(SectorPlan& plan, BladesOfFile& wheel, const FileBlade& blade, const SectionSurface& main,
                  double blunt_edge) {
  const SplitterSurface splitter(blade.file, main, *blade.splitter, blunt_edge, plan.pitch());
  plan.blades = Blades::main_and_splitter;
  plan.splitter_start = splitter.start();
  plan.splitter_pitch = blade.splitter->pitch_fraction;
  wheel.add(splitter, plan);
}

}  // namespace

std::unique_ptr<WheelGeometry> read_wheel_of_blade_file(CaseTable& table, SectorPlan& plan) {
  const auto read_blade = table.choice<decltype(&read_sections)>(
      "blade_format", std::nullopt, {{read_sections, "sections"}, {read_curves, "curve"}, {read_meanlines, "rtzt"}});
  FileBlade blade = read_blade(table);
  turn_towards_positive(table, blade);
  if (blade.blade_count.value_or(plan.sector_count) != plan.sector_count)
    table.reject("blade_count", "= " + std::to_string(plan.sector_count) + ", and blade_file says " +
                                    std::to_string(*blade.blade_count) + "; they must agree");
  const double blunt =
      table.number("blunt_edge", usual_blunt_edge, Range::between(0.0, widest_blunt_edge), "of the chord");
  const SectionSurface main(blade.sections, blunt);
  auto wheel = std::make_unique<BladesOfFile>(main);
  plan.blades = Blades::main;
  const auto stand = table.choice<decltype(&stand_alone)>(
      "disc", std::nullopt,
      {{stand_on_profile, "profile"}, {stand_on_back_face, "back_face"}, {stand_alone, "none"}});
  if (blade.splitter && stand != stand_alone) add_splitter(plan, *wheel, blade, main, blunt);
  stand(table, plan, *wheel);
  return wheel;
}

}  // namespace tiprub::mesh
