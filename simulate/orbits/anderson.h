// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <functional>

namespace tiprub {

struct AndersonLimits {
  double tolerance;   ///< [1] of |G(x) - x|/|G(x)|
  int evaluations;    ///< of G, at most
  int depth = 8;      ///< former steps that are combined
  int restarts = 4;   ///< after a residual that leapt up, at most
  double leap = 3;    ///< times the smallest residual so far: no step forward
  int patience = 60;  ///< evaluations without a smaller residual: no use
};

struct FixedPoint {
  enum class Reached { yes, no };

  Reached reached = Reached::no;
  Eigen::VectorXd x;    ///< the image with the smallest residual
  double residual = 0;  ///< [1] |G(x) - x|/|G(x)| there
  int evaluations = 0;
};

/// x = G(x) by Anderson's acceleration (1965; type II of Fang, Saad 2009): with f = G(x) - x,
///   x+ = G(x) - dG gamma,   gamma = argmin |f - dF gamma|,
/// over the last `depth` differences of G and f, by a pivoted QR. For a linear G this is GMRES, and it needs no
/// derivatives. It converges to unstable fixed points as well: who asks must look at their stability. Contact makes
/// G rough, so the residual may leap: then the memory is dropped and the iteration goes on from the best image so
/// far. Costs one evaluation and 2 n depth^2 multiplications a step; plain iteration needs ln(eps)/ln(rho) of them.
/// A residual that is no number counts as a leap; nothing is raised but by G.
///
/// NOX has Anderson's acceleration too, on vectors of its own, with neither restart from the best image nor patience,
/// both of which contact needs. Loading libtrilinos_nox and the 27 libraries behind it takes 30 ms of processor time,
/// where all of `tiprub-simulate --version` takes 21 ms (best of 30 starts of each).
FixedPoint find_fixed_point(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& map,
                            const Eigen::VectorXd& start, const AndersonLimits& limits);

}  // namespace tiprub
