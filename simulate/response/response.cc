// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/response.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "reduce/model/reduced_model.h"

namespace tiprub {

namespace {

/// [1] The value at an edge of a polynomial along the tip, as a sum over its means in the outermost segments.
/// Segments are means with hat functions (see reduce/sector/contact_unknowns.h), the outermost one with half of a
/// hat.
const std::vector<double>& weights_at_edge(int segments) {
  static const std::vector<double> weights[] = {{1}, {2, -1}, {1.5, -0.5}, {33.0 / 18, -19.0 / 18, 4.0 / 18}};
  return weights[std::min(segments, 4) - 1];
}

/// [m] Of one place; samples x 3.
template <class Places>
double excursion(const Places& places) {
  const Eigen::RowVector3d mean = places.colwise().mean();
  const auto square = [&](int axis) { return (places.col(axis).array() - mean[axis]).square(); };
  return std::sqrt((square(0) + square(1) + square(2)).maxCoeff());
}

/// [m] The largest excursion of the edges of one blade; its segments are `first` to `first + step * (count - 1)`.
double edge_excursion(const Eigen::Ref<const Eigen::MatrixXd>& sector, int first, int step, int count) {
  Eigen::MatrixX3d edge = Eigen::MatrixX3d::Zero(sector.rows(), 3);
  for (const double weight : weights_at_edge(count)) {
    edge += weight * sector.middleCols<3>(3 * first);
    first += step;
  }
  return excursion(edge);
}

double excursion_of_edges(const Eigen::Ref<const Eigen::MatrixXd>& sector, const ContactLine& contact) {
  if (contact.kind == ContactKind::points) return 0;
  const int splitter = contact.splitter_nodes, main = contact.size() - splitter;
  const double of_main = std::max(edge_excursion(sector, 0, 1, main), edge_excursion(sector, main - 1, -1, main));
  if (splitter == 0) return of_main;
  return std::max(
      {of_main, edge_excursion(sector, main, 1, splitter), edge_excursion(sector, contact.size() - 1, -1, splitter)});
}

/// [m] Of the tips of each sector.
std::vector<double> excursions(const Eigen::MatrixXd& displacement, const ContactLine& contact) {
  std::vector<double> sectors;
  const int dofs = 3 * contact.size();
  for (Eigen::Index first = 0; first + dofs <= displacement.cols(); first += dofs) {
    const auto sector = displacement.middleCols(first, dofs);
    sectors.push_back(excursion_of_edges(sector, contact));
    for (int node = 0; node < contact.size(); ++node)
      sectors.back() = std::max(sectors.back(), excursion(sector.middleCols<3>(3 * node)));
  }
  return sectors;
}

}  // namespace

Eigen::VectorXd SimulatedScene::distortion_over(int node) const {
  return node_distortion.size() > 0 ? Eigen::VectorXd(node_distortion.col(node)) : casing_distortion;
}

Eigen::VectorXd SimulatedScene::interference(const Eigen::VectorXd& running_clearance) const {
  if (node_crest.size() > 0) return node_crest - running_clearance;
  return crest() - running_clearance.array();
}

double largest_excursion(const Eigen::MatrixXd& displacement, const ContactLine& contact) {
  return std::ranges::max(excursions(displacement, contact));
}

BladeExcursions blade_excursions(const Eigen::MatrixXd& displacement, const ContactLine& contact) {
  std::vector<double> blades = excursions(displacement, contact);
  std::ranges::sort(blades);
  const std::size_t half = blades.size() / 2;
  return {blades.front(), (blades[half] + blades[blades.size() - 1 - half]) / 2, blades.back()};
}

}  // namespace tiprub
