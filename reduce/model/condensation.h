// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "reduce/model/reduced_model.h"

namespace tiprub {

/// One nodal diameter at one speed on fewer dofs: the contact dofs as they are, then fixed-interface modes.
struct CondensedModel {
  Eigen::MatrixXcd K;      ///< [N/m in contact rows]
  Eigen::MatrixXcd M;      ///< [kg in contact rows]
  Eigen::MatrixXcd basis;  ///< T of K = T^H K(Omega) T; the model's dofs x these

  /// [Hz], ascending.
  Eigen::VectorXd natural_frequencies() const;
};

/// A second Craig-Bampton inside the reduced model, at one speed [rad/s] (Craig and Bampton 1968). A basis that
/// serves all speeds holds the modes of several; at any one speed far fewer suffice. Leaving out the highest
/// frequencies lets a march take larger steps and loses hardly any accuracy. With `modes` of 0, or of at least the
/// number of generalized dofs, the model stays as it is. Costs one dense eigenproblem of the generalized dofs, which
/// takes milliseconds.
CondensedModel condense(const NodalDiameterModel& model, double speed, int contact_dofs, int modes);

}  // namespace tiprub
