// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/basis/polynomial_fit.h"

#include "reduce/operators/polynomial_fit.h"
#include "reduce/sector/parallel_for.h"

namespace tiprub {

namespace {

/// n_s x nodal diameters.
Eigen::MatrixXd misfit(const SampledStiffness& stiffness, const SpeedSamples& samples,
                       const ReductionParameters& parameters, const ReducedModel& model) {
  const auto rows = static_cast<Eigen::Index>(parameters.verification_speeds.size());
  const auto diameters = static_cast<int>(stiffness.size());
  Eigen::MatrixXd table(rows, diameters);
  parallel_for(diameters, parameters.threads, [&](int n) {
    const NodalDiameterModel& fitted = model.nodal_diameters[n];
    for (Eigen::Index row = 0; row < rows; ++row) {
      const double fraction = parameters.verification_speeds[row];
      const Eigen::MatrixXcd K = samples.combine(stiffness[n], fraction);
      const Eigen::VectorXd exact = NodalDiameterModel{{{K}}, fitted.M}.natural_frequencies(0.0);
      const Eigen::VectorXd by_polynomial = fitted.natural_frequencies(fraction * parameters.speed_max);
      table(row, n) =
          (by_polynomial.array() / exact.array() - 1).head(parameters.verification_modes).abs().maxCoeff();
    }
  });
  return table;
}

}  // namespace

void fit_polynomial(const SampledStiffness& stiffness, const SpeedSamples& samples,
                    const ReductionParameters& parameters, ReducedModel& model) {
  const PolynomialFit fit(speeds_at(samples.polynomial_fractions(), parameters.speed_max));
  for (std::size_t n = 0; n < stiffness.size(); ++n)
    model.nodal_diameters[n].K =
        fit.through(std::vector(stiffness[n].begin(), stiffness[n].begin() + samples.polynomial_terms()));
  if (parameters.prestress == Prestress::nonlinear)
    model.verification.polynomial_misfit = misfit(stiffness, samples, parameters, model);
}

}  // namespace tiprub
