// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "simulate/march/time_march.h"
#include "simulate/orbits/engine_order_band.h"

namespace tiprub {

/// How much of the tips' normal motion lies above the band of resolved frequencies: a chatter of the mesh's own
/// modes, which is no engine order's business.
class ChatterAudit {
 public:
  struct Share {
    double share = 0;  ///< [1] of the mean square without the mean, all contact nodes
    int node = 0;      ///< contact node with most of it
  };

  ChatterAudit(const TimeMarch& march, const EngineOrderBand& band);
  /// At each instant.
  void observe(const Eigen::VectorXd& displacement);
  /// The means over the samples' intervals, of each whole revolution.
  void add_revolution(const Eigen::VectorXd& motion);
  Share share() const;

 private:
  EngineOrderBand band_;
  int width_;
  double instants_ = 0, samples_ = 0;
  Eigen::ArrayXd sum_, squares_;  ///< [m], [m^2] over instants, by channel
  Eigen::ArrayXd band_squares_;   ///< [m^2] over samples
};

}  // namespace tiprub
