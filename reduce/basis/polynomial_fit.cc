// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/basis/polynomial_fit.h"

#include <iterator>
#include <limits>
#include <utility>

#include "reduce/operators/speed_polynomial.h"
#include "reduce/sector/parallel_for.h"

namespace tiprub {

namespace {

class PolynomialFit {
 public:
  PolynomialFit(const SampledStiffness& stiffness, const SpeedSamples& samples, const ReductionParameters& parameters,
                ReducedModel& model)
      : stiffness_(stiffness), samples_(samples), parameters_(parameters), model_(model) {}

  int run() {
    int best = samples_.polynomial_choices().front(), last = 0;
    double least = std::numeric_limits<double>::infinity();
    for (const int choice : samples_.polynomial_choices()) {
      const double misfit = fit_through(last = choice);
      if (misfit < least) best = choice;
      least = std::min(least, misfit);
      if (least < parameters_.polynomial_tolerance) break;
    }
    if (best != last) fit_through(best);
    return best;
  }

 private:
  /// Returns the misfit.
  double fit_through(int count) {
    const std::vector<double> fractions = SpeedSamples::polynomial_fractions(count);
    const SpeedPolynomial polynomial(speeds_at(fractions, parameters_.speed_max));
    for (std::size_t n = 0; n < stiffness_.size(); ++n) {
      std::vector<Eigen::MatrixXcd> through;
      through.reserve(fractions.size());
      for (const double fraction : fractions) through.push_back(samples_.combine(stiffness_[n], fraction));
      std::vector<Eigen::MatrixXcd> terms = polynomial.coefficients(through);
      NodalDiameterModel& to = model_.nodal_diameters[n];
      to.K0 = std::move(terms[0]);
      to.K1 = std::move(terms[1]);
      to.K2 = std::move(terms[2]);
      to.higher.assign(std::make_move_iterator(terms.begin() + 3), std::make_move_iterator(terms.end()));
    }
    return parameters_.prestress == Prestress::nonlinear ? measure() : 0.0;
  }

  /// Fills the table of misfits; returns the largest.
  double measure() {
    Eigen::MatrixXd& misfit = model_.verification.polynomial_misfit;
    const auto rows = static_cast<Eigen::Index>(parameters_.verification_speeds.size());
    const auto diameters = static_cast<int>(stiffness_.size());
    misfit.setZero(rows, diameters);
    parallel_for(diameters, parameters_.threads, [&](int n) {
      const NodalDiameterModel& fitted = model_.nodal_diameters[n];
      for (Eigen::Index row = 0; row < rows; ++row) {
        const double fraction = parameters_.verification_speeds[row];
        const Eigen::MatrixXcd K = samples_.combine(stiffness_[n], fraction);
        const Eigen::VectorXd exact = NodalDiameterModel{K, 0 * K, 0 * K, fitted.M}.natural_frequencies(0.0);
        const Eigen::VectorXd by_polynomial = fitted.natural_frequencies(fraction * parameters_.speed_max);
        misfit(row, n) =
            (by_polynomial.array() / exact.array() - 1).head(parameters_.verification_modes).abs().maxCoeff();
      }
    });
    return misfit.maxCoeff();
  }

  const SampledStiffness& stiffness_;
  const SpeedSamples& samples_;
  const ReductionParameters& parameters_;
  ReducedModel& model_;
};

}  // namespace

int fit_polynomial(const SampledStiffness& stiffness, const SpeedSamples& samples,
                   const ReductionParameters& parameters, ReducedModel& model) {
  return PolynomialFit(stiffness, samples, parameters, model).run();
}

}  // namespace tiprub
