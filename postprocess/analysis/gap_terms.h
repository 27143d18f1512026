// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>

#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub::postprocess {

/// [1] of the interference: terms of second order beyond it decide where and how hard a tip touches.
inline constexpr double allowed_gap_terms = 0.1;

/// [m] The terms of second order in the vibration u that the linear gap, clearance - distortion - nu . u, leaves
/// out. Each is the largest over contact nodes, sectors and samples of one speed.
struct GapTerms {
  /// (c_1 u_theta^2 + c_2 u_m^2)/2 with the casing's curvatures of the model, or nu_r u_theta^2/(2 r) without them: a
  /// tip that moves along the tangent leaves its circle outwards, and comes nearer to a round casing.
  double curvature = 0;
  /// |d'| |u_theta|/r, with d' the steepest slope of the distortion over the angle [m/rad]: the program reads the
  /// casing's shape at the angle of the tip without vibration.
  double distortion = 0;
  /// y' Q y of the model. Without it (6/5) w^2/(2 L): the shortening of a beam of length L that a force at its tip
  /// bends by w (half the integral of the squared slope of w (3 x^2 L - x^3)/(2 L^3)). w is the part of u across the
  /// normal, L the span at the node. Nothing if neither is known.
  std::optional<double> foreshortening;
  /// Curvature and foreshortening together, with their signs if the model has both; else the larger one.
  double together = 0;
  /// How far a tip that does not vibrate reaches into the casing: crest minus clearance, spin included; below zero if
  /// it does not.
  double interference = 0;
  bool modelled = false;  ///< the march has these terms

  /// [m] The largest size of a term that hardly matters.
  double allowed() const;
  /// Whether the motion leaves what a linear gap can say.
  bool beyond() const { return !modelled && together > allowed(); }
  /// "second order of the gap 0.12 mm, at an interference of 0.037 mm".
  std::string in_words() const;
};

/// `span` [m] at the contact nodes, or empty.
GapTerms gap_terms(const SpeedResponse& response, const SimulatedScene& scene, const ContactLine& contact,
                   const Eigen::VectorXd& span = {});

}  // namespace tiprub::postprocess
