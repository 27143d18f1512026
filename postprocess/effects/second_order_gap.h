// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <optional>

#include "reduce/model/fields_file.h"
#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub {

/// [m] What a gap that is linear in the displacement, c - d - n . u, leaves out: terms with the square of the
/// vibration u. Each the largest over contact nodes, sectors and samples of one speed.
struct SecondOrderGap {
  /// n_r u_theta^2/(2 r): a tip that moves along the tangent ends farther out than the circle that it left, so that a
  /// round casing is nearer.
  double curvature = 0;
  /// |d'| |u_theta|/r, d' the steepest slope of the distortion over the angle [m/rad]: the casing is read where the
  /// tip would be at rest.
  double distortion = 0;
  /// (6/5) w^2/(2 L): by so much a beam of length L, bent by a force at its tip that moves it by w, draws its tip
  /// back (half the integral of the squared slope of w (3 x^2 L - x^3)/(2 L^3)). w is what u has across the normal, L
  /// the span at the node. Nothing where no span is known.
  std::optional<double> foreshortening;
};

/// `span` [m] at the contact nodes, or empty.
SecondOrderGap second_order_gap(const SpeedResponse& response, const SimulatedScene& scene,
                                const ContactLine& contact, const Eigen::VectorXd& span);

/// [m] From each contact node to the nearest node of the part `disc`; empty without that part.
Eigen::VectorXd tip_spans(const SectorFields& sector);

}  // namespace tiprub
