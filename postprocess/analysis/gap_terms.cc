// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/gap_terms.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

/// [m/rad] The steepest slope between neighbouring points.
double steepest_slope(const Eigen::VectorXd& angle, const Eigen::VectorXd& distortion) {
  double steepest = 0;
  for (Eigen::Index i = 0; i + 1 < angle.size(); ++i)
    steepest = std::max(steepest, std::abs((distortion[i + 1] - distortion[i]) / (angle[i + 1] - angle[i])));
  return steepest;
}

/// The terms at one contact node of one sector by the model's curvatures and Q. `motion`: samples x 3; `y`: samples x
/// coordinates, of that sector.
void add_model_terms(const SecondOrderGap& model, Eigen::Index node, const Eigen::RowVector3d& normal,
                     const Eigen::MatrixX3d& motion, const Eigen::MatrixXd& y, GapTerms& terms) {
  const Eigen::Vector3d meridian = Eigen::Vector3d(normal[2], 0, -normal[0]).normalized();
  const Eigen::VectorXd along = motion * meridian;
  const Eigen::VectorXd curvature =
      0.5 * (model.curvature(node, 0) * motion.col(1).cwiseAbs2() + model.curvature(node, 1) * along.cwiseAbs2());
  const Eigen::MatrixXd& Q = model.displacement[static_cast<std::size_t>(node)];
  const Eigen::VectorXd bending = (y * Q).cwiseProduct(y).rowwise().sum();
  terms.curvature = std::max(terms.curvature, curvature.cwiseAbs().maxCoeff());
  terms.foreshortening = std::max(*terms.foreshortening, bending.cwiseAbs().maxCoeff());
  terms.together = std::max(terms.together, (curvature + bending).cwiseAbs().maxCoeff());
}

/// The same by a circle and a beam; `span` is zero if it is not known.
void add_estimates(double radius, double span, const Eigen::RowVector3d& normal, const Eigen::MatrixX3d& motion,
                   GapTerms& terms) {
  const double tangential = motion.col(1).cwiseAbs().maxCoeff();
  terms.curvature = std::max(terms.curvature, std::abs(normal[0]) * tangential * tangential / (2 * radius));
  if (terms.foreshortening) {
    const Eigen::VectorXd along = motion * normal.transpose();
    const double bending = (motion - along * normal).rowwise().squaredNorm().maxCoeff();
    terms.foreshortening = std::max(*terms.foreshortening, 0.6 * bending / span);
  }
  terms.together = std::max(terms.curvature, terms.foreshortening.value_or(0));
}

bool models_second_order(const SimulatedScene& scene) {
  const ModelledEffect* const known = find(scene.effects, Effect::blade_foreshortening);
  return known != nullptr && known->treatment == Treatment::modelled;
}

}  // namespace

double GapTerms::allowed() const {
  return allowed_gap_terms * std::max(interference, 0.0);
}

std::string GapTerms::in_words() const {
  constexpr int digits = 2;
  return "second order of the gap " + significant(together * mm_per_m, digits) + " mm, at an interference of " +
         significant(interference * mm_per_m, digits) + " mm";
}

GapTerms gap_terms(const SpeedResponse& response, const SimulatedScene& scene, const ContactLine& contact,
                   const Eigen::VectorXd& span) {
  const auto& model = contact.second_order;
  GapTerms terms;
  terms.modelled = models_second_order(scene);
  terms.interference = scene.interference(response.clearance).maxCoeff();
  if (model || span.size() > 0) terms.foreshortening = 0;
  std::vector<double> slope;  // over each node
  for (int node = 0; node < contact.size(); ++node)
    slope.push_back(steepest_slope(scene.casing_angle, scene.distortion_over(node)));
  const Eigen::Index width = 3 * static_cast<Eigen::Index>(contact.size());
  for (Eigen::Index first = 0; first < response.displacement.cols(); first += width) {
    const auto sector = response.displacement.middleCols(first, width);
    const Eigen::MatrixXd y = model ? Eigen::MatrixXd(sector * model->coordinates) : Eigen::MatrixXd();
    for (Eigen::Index node = 0; node < contact.size(); ++node) {
      const Eigen::MatrixX3d motion = sector.middleCols<3>(3 * node);
      const double radius = contact.position(node, 0), tangential = motion.col(1).cwiseAbs().maxCoeff();
      terms.distortion = std::max(terms.distortion, slope[static_cast<std::size_t>(node)] * tangential / radius);
      if (model)
        add_model_terms(*model, node, contact.normal.row(node), motion, y, terms);
      else
        add_estimates(radius, span.size() > 0 ? span[node] : 0, contact.normal.row(node), motion, terms);
    }
  }
  return terms;
}

}  // namespace tiprub::postprocess
