// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <memory>
#include <vector>

#include "simulate/march/time_march.h"
#include "simulate/periodic/contact_pattern.h"
#include "simulate/periodic/symmetric_map.h"

namespace tiprub {

/// Which of a wheel's disturbances are followed along an orbit.
enum class Disturbance {
  symmetric,  ///< the orbit's own nodal diameters
  excluded,   ///< those that symmetry leaves out; the two don't mix in first order
};

/// The march linearised along an orbit's own contact pattern: nodes that the orbit has closed stay where they are,
/// all others feel no force. Costs what the march costs, without its search for the pattern.
class TangentMarch {
 public:
  /// Of an orbit's march. Excluded disturbances are those of RotorAtSpeed::others, on all N sectors. `power`: of the
  /// symmetric map, whose pattern it follows.
  TangentMarch(const TimeMarch& orbit, Disturbance disturbance, int power);

  Eigen::Index size() const { return map_.state().size(); }
  double maps_per_revolution() const { return map_.maps_per_revolution(); }
  /// DF times a change of the state, as SymmetricMap has it. Raises NoMotion if nodes that the pattern closes
  /// together can't be.
  Eigen::VectorXd operator()(const std::shared_ptr<const ContactPattern>& pattern, const Eigen::VectorXd& change);

 private:
  void hold(const std::shared_ptr<const ContactPattern>& pattern);
  std::vector<int> on_all_sectors(const std::vector<int>& nodes) const;

  TimeMarch march_;
  SymmetricMap map_;
  int copies_, nodes_a_copy_;   ///< of the orbit's sectors in this march, and what lies between two of them
  Eigen::MatrixXd compliance_;  ///< [m/N] W, of full rank
  std::shared_ptr<const ContactPattern> pattern_;
  std::vector<std::vector<int>> closed_;  ///< the pattern's sets, on all sectors
  std::vector<Eigen::LLT<Eigen::MatrixXd>> factors_;
  Eigen::VectorXd forces_, of_set_;
};

}  // namespace tiprub
