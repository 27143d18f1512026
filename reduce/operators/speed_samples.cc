// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/speed_samples.h"

#include <algorithm>
#include <set>

#include "reduce/operators/speed_polynomial.h"

namespace tiprub {

std::vector<double> speeds_at(std::vector<double> fractions, double speed_max) {
  for (double& fraction : fractions) fraction *= speed_max;
  return fractions;
}

SpeedSamples::SpeedSamples(const ReductionParameters& parameters) {
  const bool linear = parameters.prestress != Prestress::nonlinear;
  polynomial_choices_ = parameters.polynomial_speeds > 0 ? std::vector{parameters.polynomial_speeds}
                        : linear                         ? std::vector{3}
                                                         : std::vector{3, 5};
  std::set<double> all;
  for (const int speeds : polynomial_choices_)
    for (const double fraction : polynomial_fractions(speeds)) all.insert(fraction);
  if (!linear) {
    all.insert(corrected_speeds.begin(), corrected_speeds.end());
    all.insert(parameters.verification_speeds.begin(), parameters.verification_speeds.end());
  }
  fractions_.assign(all.begin(), all.end());
}

std::vector<double> SpeedSamples::polynomial_fractions(int speeds) {
  std::vector<double> fractions(speeds);
  for (int i = 0; i < speeds; ++i) fractions[i] = static_cast<double>(i) / (speeds - 1);
  return fractions;
}

std::optional<std::size_t> SpeedSamples::find(double fraction) const {
  const auto sample = std::find(fractions_.begin(), fractions_.end(), fraction);
  if (sample == fractions_.end()) return std::nullopt;
  return sample - fractions_.begin();
}

Eigen::VectorXd SpeedSamples::weights(double fraction) const {
  if (const auto sample = find(fraction))
    return Eigen::VectorXd::Unit(static_cast<Eigen::Index>(fractions_.size()), static_cast<Eigen::Index>(*sample));
  return SpeedPolynomial(fractions_).weights(fraction);
}

Eigen::MatrixXcd SpeedSamples::combine(const std::vector<Eigen::MatrixXcd>& samples, double fraction) const {
  const Eigen::VectorXd weight = weights(fraction);
  Eigen::MatrixXcd sum = Eigen::MatrixXcd::Zero(samples.front().rows(), samples.front().cols());
  for (Eigen::Index s = 0; s < weight.size(); ++s)
    if (weight[s] != 0) sum += weight[s] * samples[s];
  return sum;
}

}  // namespace tiprub
