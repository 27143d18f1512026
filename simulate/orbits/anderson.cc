// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/anderson.h"

#include <algorithm>
#include <limits>

namespace tiprub {

namespace {

/// The last differences, in columns used in turn.
class Memory {
 public:
  Memory(Eigen::Index size, int depth) : images_(size, depth), residuals_(size, depth) {}

  void drop() { held_ = 0, has_last_ = false; }

  void add(const Eigen::VectorXd& image, const Eigen::VectorXd& residual) {
    if (has_last_) {
      const Eigen::Index column = next_++ % images_.cols();
      images_.col(column) = image - last_image_;
      residuals_.col(column) = residual - last_residual_;
      held_ = std::min<Eigen::Index>(held_ + 1, images_.cols());
    } else {
      next_ = 0;
    }
    last_image_ = image;
    last_residual_ = residual;
    has_last_ = true;
  }

  Eigen::VectorXd step() const {
    if (held_ == 0) return last_image_;
    const Eigen::VectorXd gamma = residuals_.leftCols(held_).colPivHouseholderQr().solve(last_residual_);
    return last_image_ - images_.leftCols(held_) * gamma;
  }

 private:
  Eigen::MatrixXd images_, residuals_;
  Eigen::VectorXd last_image_, last_residual_;
  Eigen::Index held_ = 0, next_ = 0;
  bool has_last_ = false;
};

}  // namespace

FixedPoint find_fixed_point(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& map,
                            const Eigen::VectorXd& start, const AndersonLimits& limits) {
  FixedPoint best;
  best.x = start;
  best.residual = std::numeric_limits<double>::infinity();
  Memory memory(start.size(), limits.depth);
  Eigen::VectorXd x = start;
  int restarts = 0, since_best = 0;
  while (best.evaluations < limits.evaluations && since_best < limits.patience) {
    const Eigen::VectorXd image = map(x);
    ++best.evaluations;
    ++since_best;
    const Eigen::VectorXd change = image - x;
    const double norm = image.norm();
    const double residual = norm > 0 ? change.norm() / norm : change.norm();
    if (!(residual <= limits.leap * best.residual)) {
      if (++restarts > limits.restarts) break;
      memory.drop();
      x = best.x;
      continue;
    }
    if (residual < best.residual) {
      best.residual = residual;
      best.x = image;
      since_best = 0;
    }
    if (residual <= limits.tolerance) {
      best.reached = FixedPoint::Reached::yes;
      break;
    }
    memory.add(image, change);
    x = memory.step();
  }
  return best;
}

}  // namespace tiprub
