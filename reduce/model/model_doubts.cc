// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/model_doubts.h"

#include <sstream>

namespace tiprub {

namespace {

constexpr double largest_shift = 0.02;      // of the radius
constexpr double tolerable_misfit = 0.001;  // error of a frequency caused by eq. 7

}  // namespace

std::string doubts(const ReducedModel& model) {
  const ContactLine& contact = model.contact;
  std::ostringstream text;
  const Eigen::VectorXd shift = contact.static_shift(model.speed_max).rowwise().norm();
  Eigen::Index node = 0;
  const double share = shift.cwiseQuotient(contact.position.col(0)).maxCoeff(&node);
  if (share > largest_shift)
    text << "warning: spin moves the tip by " << shift[node] << " m at " << model.speed_max << " rad/s, "
         << 100 * share << " % of its radius: are young_modulus [Pa], density [kg/m^3] and the speed right? ";
  const Eigen::MatrixXd& misfit = model.verification.polynomial_misfit;
  if (misfit.size() > 0 && misfit.maxCoeff() > tolerable_misfit)
    text << "warning: the shape changes too much for eq. 7 between its speeds, frequencies are off by up to "
         << 100 * misfit.maxCoeff()
         << " %; lower speed_max_rpm, leave polynomial_speeds at 0, or take prestress = \"linear\", for which eq. 7 "
            "is "
            "exact; ";
  return text.str();
}

}  // namespace tiprub
