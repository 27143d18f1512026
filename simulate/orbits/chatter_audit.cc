// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/chatter_audit.h"

namespace tiprub {

ChatterAudit::ChatterAudit(const TimeMarch& march, const EngineOrderBand& band)
    : band_(band),
      width_(march.width()),
      sum_(Eigen::ArrayXd::Zero(march.displacement().size())),
      squares_(sum_),
      band_squares_(sum_) {}

void ChatterAudit::observe(const Eigen::VectorXd& displacement) {
  sum_ += displacement.array();
  squares_ += displacement.array().square();
  ++instants_;
}

void ChatterAudit::add_revolution(const Eigen::VectorXd& motion) {
  band_squares_ += band_.coefficients(motion).rowwise().squaredNorm().array();
  const Eigen::Index samples = motion.size() / sum_.size();
  samples_ += static_cast<double>(samples);
}

ChatterAudit::Share ChatterAudit::share() const {
  const Eigen::ArrayXd mean_square = (sum_ / instants_).square();
  const Eigen::ArrayXd all = squares_ / instants_ - mean_square;
  const Eigen::ArrayXd above = (all - (band_squares_ / samples_ - mean_square)).max(0.0);
  if (!(all.sum() > 0)) return {};
  Eigen::VectorXd by_node = Eigen::VectorXd::Zero(width_);
  for (Eigen::Index i = 0; i < above.size(); ++i) by_node[i % width_] += above[i];
  Share share{above.sum() / all.sum(), 0};
  by_node.maxCoeff(&share.node);
  return share;
}

}  // namespace tiprub
