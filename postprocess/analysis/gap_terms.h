// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>

#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub::postprocess {

/// [1] The share of the interference up to which terms of second order count as negligible. Larger terms determine
/// where and how hard a tip touches.
inline constexpr double allowed_gap_terms = 0.1;

/// [m] The terms of second order in the vibration u that the linear gap, clearance - distortion - nu . u, leaves out.
/// Each is the largest of all contact nodes, sectors and samples of one speed.
struct GapTerms {
  /// The curvature of the casing: (c_1 u_theta^2 + c_2 u_m^2)/2 with the curvatures of the model, or nu_r
  /// u_theta^2/(2 r) without them. A tip that moves along its tangent comes nearer to a round casing.
  double curvature = 0;
  /// The slope of the casing: |d'| |u_theta|/r with the steepest slope d' of the distortion over the angle [m/rad].
  /// The linear gap reads the distortion at the angle of the tip at rest.
  double distortion = 0;
  /// The foreshortening of the blade: y' Q y of the model. Without Q it is (6/5) w^2/(2 L), the shortening of a beam
  /// of the length L that a force at its tip bends by w (half the integral of the squared slope of w (3 x^2 L -
  /// x^3)/(2 L^3)); w is the part of u across the normal, L the span at the node. Empty if neither is known.
  std::optional<double> foreshortening;
  /// Curvature and foreshortening together: the largest magnitude of their sum if the model has both, otherwise the
  /// larger of the two.
  double together = 0;
  /// The interference: how far a tip that does not vibrate reaches into the casing, the largest over the contact
  /// nodes of the crest over the node minus its clearance, spin included. Negative if no node reaches it.
  double interference = 0;
  bool modelled = false;  ///< whether the march contains these terms

  /// [m] The largest size of a negligible term.
  double allowed() const;
  /// Whether the motion is outside the range in which the linear gap of its march holds.
  bool beyond() const { return !modelled && together > allowed(); }
  /// "second order of the gap 0.12 mm, at an interference of 0.037 mm".
  std::string in_words() const;
};

/// `span` [m] is that of the blade at the contact nodes; it may be empty.
GapTerms gap_terms(const SpeedResponse& response, const SimulatedScene& scene, const ContactLine& contact,
                   const Eigen::VectorXd& span = {});

}  // namespace tiprub::postprocess
