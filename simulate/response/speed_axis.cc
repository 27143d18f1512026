// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/speed_axis.h"

#include <limits>
#include <optional>
#include <type_traits>

#include "simulate/response/speed_numbers.h"

namespace tiprub {

namespace {

const std::string axis = "/rotor_speed";
constexpr double none = std::numeric_limits<double>::quiet_NaN();

Array<double> along_one_axis(const std::vector<double>& values) {
  return {{values.size()}, values};
}

}  // namespace

void SpeedAxis::add(const SpeedResponse& speed) {
  speeds_.push_back(speed.speed);
  std::size_t place = 0;
  const auto note = [&](bool held, const NumberMeaning& meaning, const auto& value) {
    if (place == numbers_.size()) numbers_.push_back({meaning.name, meaning.units, meaning.long_name, {}});
    double number = none;
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::optional<double>>)
      number = value.value_or(none);
    else
      number = static_cast<double>(value);
    numbers_[place++].values.push_back(held ? number : none);
  };
  visit_numbers(
      speed, [&](const NumberMeaning& meaning, const auto& value) { note(speed.failure.empty(), meaning, value); });
  const OrbitReport& orbit = speed.audit.orbit;
  visit_orbit_numbers(orbit, [&](const NumberMeaning& meaning, const auto& value) {
    note(orbit.outcome != OrbitReport::Outcome::none, meaning, value);
  });
  place = 0;
  for (SpeedText& text : texts_of(speed)) {
    if (place == texts_.size()) texts_.push_back({text.name, text.long_name, {}});
    texts_[place++].values.push_back(std::move(text.value));
  }
}

void SpeedAxis::write(Hdf5File& file) const {
  file.write(axis, along_one_axis(speeds_), "rad/s");
  file.make_axis(axis);
  file.describe(axis, "speed of the rotor");
  for (const Numbers& column : numbers_) {
    const std::string name = std::string("/") + column.name;
    file.write(name, along_one_axis(column.values), column.units);
    file.describe(name, column.long_name, {axis});
  }
  for (const Texts& column : texts_) {
    const std::string name = std::string("/") + column.name;
    file.write(name, column.values);
    file.describe(name, column.long_name, {axis});
  }
}

}  // namespace tiprub
