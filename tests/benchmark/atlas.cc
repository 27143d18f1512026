// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "simulate/scene/friction_limit.h"
#include "tests/benchmark/benchmarks.h"
#include "tests/benchmark/trial.h"

namespace tiprub::simulate::testing {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr int default_steps = 1920;
constexpr double chatter_band = 8;  // of the lowest frequency: what is above it is chatter
const std::vector<double> steps_a_revolution = {240, 480, 960, 1920, 3840, 7680};

/// One map: a cell a row and column, each a trial. Rows of one scene share its reference.
struct Map {
  const char* name;
  const char* columns;  ///< what varies along a row
  std::vector<std::string> rows;
  std::vector<double> values;
  std::function<Trial(std::size_t row, double value)> trial;
  bool own_reference = true;  ///< each row has a scene of its own
  bool classes = false;       ///< the class of the motion instead of its error
};

void print(const Map& map) {
  Reference reference;
  for (std::size_t row = 0; row < map.rows.size(); ++row) {
    if (map.own_reference) reference = Reference();
    for (std::size_t column = 0; column < map.values.size(); ++column) {
      const Trial trial = map.trial(row, map.values[column]);
      const Verdict verdict = map.classes ? classify(trial) : try_out(trial, reference);
      std::printf("%s\t%zu\t%s\t%zu\t%g\t%s\t%.3g\t%s\n", map.name, row, map.rows[row].c_str(), column,
                  map.values[column], name_of(verdict.outcome), verdict.number, verdict.note.c_str());
      std::fflush(stdout);
    }
  }
}

/// [Hz] at rest, of all nodal diameters.
double lowest_frequency(const BenchWheel& wheel) {
  double lowest = HUGE_VAL;
  for (const NodalDiameterModel& at : wheel.model.nodal_diameters)
    lowest = std::min(lowest, at.natural_frequencies(0)[0]);
  return lowest;
}

Trial stepped(const BenchWheel& wheel, double steps) {
  Trial trial{wheel, bench_parameters(wheel, patience)};
  trial.parameters.resolved_frequency = chatter_band * lowest_frequency(wheel);
  trial.parameters.steps_per_revolution = static_cast<int>(steps);
  return trial;
}

Map schemes(const BenchWheel& wheel) {
  static const std::vector<Scheme> all = {Scheme::trigonometric, Scheme::residual_flexibility, Scheme::moreau_jean,
                                          Scheme::central_differences, Scheme::penalty};
  return {"scheme",
          "steps a revolution",
          {"default", "residual flexibility, 20 modes", "Moreau-Jean, 1/2", "central differences", "penalty, 100"},
          steps_a_revolution,
          [&wheel](std::size_t row, double steps) {
            Trial trial = stepped(wheel, steps);
            trial.parameters.scheme = all[row];
            if (all[row] == Scheme::residual_flexibility) trial.parameters.modes = 20;
            return trial;
          },
          false};
}

/// The default and central differences beside each other, on wheels that differ in one number.
Map pairs(const char* name, const std::vector<std::string>& labels,
          const std::function<BenchWheel(std::size_t)>& of) {
  std::vector<std::string> rows;
  for (const std::string& label : labels) {
    rows.push_back(label + ", default");
    rows.push_back(label + ", central");
  }
  return {name, "steps a revolution", rows, steps_a_revolution, [of](std::size_t row, double steps) {
            Trial trial = stepped(of(row / 2), steps);
            if (row % 2 == 1) trial.parameters.scheme = Scheme::central_differences;
            return trial;
          }};
}

Map damping() {
  return pairs("damping ratio", {"0.0005", "0.005", "0.05"}, [](std::size_t i) {
    BenchWheel wheel = made_wheel(2);
    wheel.damping = std::vector{0.0005, 0.005, 0.05}[i];
    return wheel;
  });
}

Map tips() {
  return pairs("tips' share of mass", {"0.2", "0.04", "0.01", "1e-4"}, [](std::size_t i) {
    return made_wheel(2, std::vector{0.2, 0.04, 0.01, 1e-4}[i]);
  });
}

/// One number of a scheme against the steps.
Map number_of(Scheme scheme, const char* name, double SimulateParameters::*number, const std::vector<double>& values,
              const std::vector<double>& steps) {
  std::vector<std::string> rows;
  for (const double value : values) rows.push_back((std::ostringstream() << value).str());
  return {name,
          "steps a revolution",
          rows,
          steps,
          [=](std::size_t row, double count) {
            Trial trial = stepped(made_wheel(2), count);
            trial.parameters.scheme = scheme;
            trial.parameters.*number = values[row];
            return trial;
          },
          false};
}

Map penalty() {
  return number_of(Scheme::penalty, "penalty", &SimulateParameters::penalty_stiffness, {1, 10, 100, 1000, 10000},
                   {1920, 3840, 7680, 15360, 30720, 61440});
}

Map theta() {
  return number_of(Scheme::moreau_jean, "Moreau-Jean's theta", &SimulateParameters::theta, {0.4, 0.48, 0.5, 0.6, 1},
                   steps_a_revolution);
}

Map modes() {
  return {"modes kept",
          "modes a nodal diameter",
          {"dropped", "quasi-static"},
          {8, 20, 40, 60, 75, 90},
          [](std::size_t row, double count) {
            Trial trial = stepped(made_wheel(2), default_steps);
            trial.parameters.modes = static_cast<int>(count);
            if (row == 1) trial.parameters.scheme = Scheme::residual_flexibility;
            return trial;
          },
          false};
}

Map rules() {
  return {"rule of contact",
          "steps a revolution",
          {"default", "central differences", "eqs. 14 and 15, sign of eq. 14"},
          {960, 1920, 3840, 7680, 15360},
          [](std::size_t row, double steps) {
            Trial trial = stepped(made_wheel(2), steps);
            if (row > 0) trial.parameters.scheme = Scheme::central_differences;
            if (row == 2) trial.parameters.contact = ContactRule::paper;
            return trial;
          },
          false};
}

Map bumps() {
  static const std::vector<double> widths = {40, 10, 4, 2, 1, 0.5};
  return {"width of a bump [deg]",
          "steps a revolution",
          {"40", "10", "4", "2", "1", "0.5"},
          steps_a_revolution,
          [](std::size_t row, double steps) {
            BenchWheel wheel = made_wheel(2);
            wheel.casing.shape = CasingShape::bumps;
            wheel.casing.bump_width = widths[row] * degree;
            return stepped(wheel, steps);
          }};
}

/// Lobes that don't reach, graze, and close the clearance; and a casing that presses all around, where no node opens.
Map lobes() {
  static const std::vector<double> reach = {0.9, 1.001, 1.5, 3, 10};
  return {"lobes over clearance",
          "steps a revolution",
          {"0.9", "1.001", "1.5", "3", "10", "pressed all around"},
          steps_a_revolution,
          [](std::size_t row, double steps) {
            BenchWheel wheel = made_wheel(2);
            const double clearance = wheel.casing.clearance[0][1];
            const bool pressed = row == reach.size();
            wheel.casing.amplitude = (pressed ? 0.1 : reach[row]) * clearance;
            if (pressed) wheel.casing.clearance = {{0.0, -clearance}, {1.0, -clearance}};
            return stepped(wheel, steps);
          }};
}

/// K = K0 - s Omega^2 M takes the lowest mode's stiffness away at the wheel's own speed.
Map softening() {
  return {"spin that softens",
          "speed over the critical one",
          {"default"},
          {0.5, 0.9, 0.99, 1.01, 1.1},
          [](std::size_t /*row*/, double share) {
            BenchWheel wheel = made_wheel(2);
            const double ratio = 2 * std::numbers::pi * lowest_frequency(wheel) / wheel.speed;
            for (NodalDiameterModel& at : wheel.model.nodal_diameters) at.K[1] = -ratio * ratio * at.M;
            wheel.speed *= share;
            Trial trial = stepped(wheel, default_steps);
            trial.own_reference = true;
            return trial;
          }};
}

/// Up to the coefficient at which a tip that is held in contact digs into the casing, and beyond.
Map friction(const BenchWheel& wheel) {
  const double limit = friction_limit(wheel.model).coefficient;
  return pairs("friction over its limit", {"0", "0.25", "0.5", "0.75", "0.95", "1.05"},
               [&wheel, limit](std::size_t i) {
                 BenchWheel rubbed = wheel;
                 rubbed.casing.friction = {{0.0, std::vector{0.0, 0.25, 0.5, 0.75, 0.95, 1.05}[i] * limit}};
                 return rubbed;
               });
}

/// What kind of motion there is.
Map classes() {
  static const std::vector<double> ratios = {0.0005, 0.001, 0.002, 0.005, 0.02};
  Map map{
      "class over damping", "lobes over clearance", {}, {1.01, 1.5, 2, 3, 5, 10}, [](std::size_t row, double reach) {
        BenchWheel wheel = made_wheel(2);
        wheel.damping = ratios[row];
        wheel.casing.amplitude = reach * wheel.casing.clearance[0][1];
        Trial trial{wheel, bench_parameters(wheel, {20, 400, 40, 1e-4})};
        trial.parameters.resolved_frequency = chatter_band * lowest_frequency(wheel);
        trial.parameters.steps_per_revolution = default_steps;
        return trial;
      }};
  for (const double ratio : ratios) map.rows.push_back((std::ostringstream() << ratio).str());
  map.classes = true;
  return map;
}

}  // namespace

void print_stability(const std::string& model) {
  const BenchWheel wheel = model.empty() ? made_wheel(2) : given_wheel(model, 2);
  std::printf("# map\trow\tname\tcolumn\tvalue\tverdict\tnumber\tnote\n");
  print(schemes(wheel));
  for (const Map& map : {damping(), tips(), penalty(), theta(), modes(), rules(), bumps(), lobes(), softening(),
                         friction(wheel), classes()}) {
    std::printf("\n\n");  // what gnuplot tells two sets by
    print(map);
  }
}

}  // namespace tiprub::simulate::testing
