// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/run_key.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>

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
  hash.add(model.modes_at_speed);
  hash.add(resolved_frequency(model));
  for (const auto* table :
       {&model.contact.position, &model.contact.normal, &model.contact.static_shift_1, &model.contact.static_shift_2})
    hash.add_matrix(*table);
  hash.add_matrix(model.contact.arc_length);
  for (const NodalDiameterModel& matrices : model.nodal_diameters) {
    for (const auto* matrix : {&matrices.K0, &matrices.K1, &matrices.K2, &matrices.M}) hash.add_matrix(*matrix);
    for (const Eigen::MatrixXcd& matrix : matrices.higher) hash.add_matrix(matrix);
  }
}

bool is_exempt(const std::string& key) {
  return std::any_of(exempt_keys().begin(), exempt_keys().end(),
                     [&](const ExemptKey& exempt) { return key == exempt.key; });
}

void add_settings(Hash& hash, const CaseSettings& settings) {
  for (const auto& [key, value] : settings) {
    if (is_exempt(key)) continue;
    const std::string line = key + " = " + value + "\n";
    hash.add_bytes(line.data(), line.size());
  }
}

}  // namespace

const std::vector<ExemptKey>& exempt_keys() {
  static const std::vector<ExemptKey> keys = {
      {"speed_min_rpm", "speeds are independent; a sweep that carries its state counts the speeds themselves"},
      {"speed_max_rpm", "as speed_min_rpm"},
      {"speed_count", "as speed_min_rpm"},
      {"speeds_rpm", "as speed_min_rpm"},
      {"speeds", "as speed_min_rpm"},
      {"scan_per_interval", "as speed_min_rpm"},
      {"speed_count_max", "as speed_min_rpm"},
      {"peak_prominence", "as speed_min_rpm"},
      {"examine", "a finished speed tells how deep it was looked at, and is computed again if that is not enough"},
      {"when_symmetry_breaks", "what is done afterwards, into another file"},
      {"threads", "results don't depend on them"},
  };
  return keys;
}

std::string run_key(const ReducedModel& model, const SweepSettings& settings, const SimulateParameters& parameters,
                    const std::string& generator) {
  Hash hash;
  hash.add(content);
  hash.add_bytes(generator.data(), generator.size());
  add_model(hash, model);
  add_settings(hash, settings.casing);
  add_settings(hash, settings.simulate);
  if (parameters.sweep != SweepDirection::rest)  // a speed's result depends on those before it
    for (double speed : parameters.speeds) hash.add(speed);
  return hash.digits();
}

}  // namespace tiprub
