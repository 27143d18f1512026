// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <memory>
#include <vector>

#include "simulate/march/time_march.h"
#include "simulate/periodic/contact_pattern.h"
#include "simulate/periodic/symmetric_map.h"

namespace tiprub {

/// Which disturbances of a wheel are followed along an orbit.
enum class Disturbance {
  symmetric,  ///< those of the nodal diameters of the orbit
  excluded,   ///< those of the nodal diameters left out; the two kinds do not couple in first order
};

/// The march linearised along the contact pattern of an orbit: nodes that the orbit closes stay in place, and no
/// force acts on the others. Costs as much as the march, without the search for the pattern.
class TangentMarch {
 public:
  /// `orbit` is the march of the orbit. Excluded disturbances are those of RotorAtSpeed::others, on all N sectors.
  /// `power` is that of the symmetric map whose pattern is followed.
  TangentMarch(const TimeMarch& orbit, Disturbance disturbance, int power);

  Eigen::Index size() const { return map_.state().size(); }
  double maps_per_revolution() const { return map_.maps_per_revolution(); }
  /// DF times a change of a state of SymmetricMap. Raises NoMotion if the compliance of nodes that the pattern closes
  /// together is singular.
  Eigen::VectorXd operator()(const std::shared_ptr<const ContactPattern>& pattern, const Eigen::VectorXd& change);

 private:
  void hold(const std::shared_ptr<const ContactPattern>& pattern);
  std::vector<int> on_all_sectors(const std::vector<int>& nodes) const;

  TimeMarch march_;
  SymmetricMap map_;
  int copies_, nodes_a_copy_;   ///< how often this march repeats the sectors of the orbit; values in each
  Eigen::MatrixXd compliance_;  ///< [m/N] W, of full rank
  std::shared_ptr<const ContactPattern> pattern_;
  std::vector<std::vector<int>> closed_;  ///< the sets of the pattern, on all sectors
  std::vector<Eigen::LLT<Eigen::MatrixXd>> factors_;
  Eigen::VectorXd forces_, of_set_;
};

}  // namespace tiprub
