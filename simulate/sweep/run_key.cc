// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/run_key.h"

#include <cstdint>
#include <cstdio>
#include <numbers>

namespace tiprub {

namespace {

/// Fowler, Noll, Vo: 64 bits, variant 1a.
class Hash {
 public:
  template <class Value>
  void add(const Value& value) {
    static_assert(std::is_arithmetic_v<Value> || std::is_enum_v<Value>);
    add_bytes(&value, sizeof(value));
  }
  template <class Matrix>
  void add_matrix(const Matrix& matrix) {
    add(static_cast<std::int64_t>(matrix.rows()));
    add(static_cast<std::int64_t>(matrix.cols()));
    add_bytes(matrix.data(), sizeof(typename Matrix::Scalar) * static_cast<std::size_t>(matrix.size()));
  }
  void add_bytes(const void* data, std::size_t count) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < count; ++i) value_ = (value_ ^ bytes[i]) * prime;
  }
  std::string digits() const {
    char text[17];
    std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(value_));
    return text;
  }

 private:
  static constexpr std::uint64_t prime = 1099511628211ULL;
  std::uint64_t value_ = 14695981039346656037ULL;
};

constexpr int content = 4;  // of a speed's result: counts up when it holds more, or means something else

void add_model(Hash& hash, const ReducedModel& model) {
  hash.add(model.sector_count);
  for (const auto* table :
       {&model.contact.position, &model.contact.normal, &model.contact.static_shift_1, &model.contact.static_shift_2})
    hash.add_matrix(*table);
  hash.add_matrix(model.contact.arc_length);
  for (const NodalDiameterModel& at : model.nodal_diameters) {
    for (const auto* matrix : {&at.K0, &at.K1, &at.K2, &at.M}) hash.add_matrix(*matrix);
    for (const Eigen::MatrixXcd& matrix : at.higher) hash.add_matrix(matrix);
  }
}

constexpr int distortion_samples = 3600;  // a table is known by its values

void add_casing(Hash& hash, const Casing& casing) {
  hash.add(casing.shape);
  hash.add(casing.lobes);
  hash.add(casing.amplitude);
  hash.add(casing.crest_angle);
  hash.add(casing.bump_width);
  for (int i = 0; i < distortion_samples; ++i)
    hash.add(casing.distortion(2 * std::numbers::pi * i / distortion_samples));
  hash.add(casing.ramp_revolutions);
  hash.add(casing.clearance_state);
  for (const auto& [fraction, clearance] : casing.clearance) {
    hash.add(fraction);
    hash.add(clearance);
  }
}

void add_parameters(Hash& hash, const SimulateParameters& parameters) {
  hash.add(parameters.scheme);
  hash.add(parameters.contact);
  hash.add(parameters.theta);
  hash.add(parameters.penalty_stiffness);
  hash.add(parameters.modes);
  hash.add(parameters.symmetry_check_revolutions);
  hash.add(parameters.sweep);
  if (parameters.sweep != SweepDirection::rest)  // a speed's result depends on those before it
    for (double speed : parameters.speeds) hash.add(speed);
  for (double ratio : parameters.damping_ratios) hash.add(ratio);
  hash.add(parameters.nodal_diameters);
  hash.add(parameters.steps_per_period);
  hash.add(parameters.steps_per_revolution);
  hash.add(parameters.samples_per_revolution);
  hash.add(parameters.recorded_revolutions);
  hash.add(parameters.min_revolutions);
  hash.add(parameters.max_revolutions);
  hash.add(parameters.settle_tolerance);
  hash.add(parameters.acceleration);
  hash.add(parameters.casing_areas);
}

}  // namespace

std::string run_key(const ReducedModel& model, const Casing& casing, const SimulateParameters& parameters,
                    const std::string& generator) {
  Hash hash;
  hash.add(content);
  hash.add_bytes(generator.data(), generator.size());
  add_model(hash, model);
  add_casing(hash, casing);
  add_parameters(hash, parameters);
  return hash.digits();
}

}  // namespace tiprub
