// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/model_doubts.h"

#include <sstream>

#include "cases/program/text.h"
#include "cases/program/units.h"

namespace tiprub {

namespace {

constexpr double largest_shift = 0.02;      // of the radius
constexpr double tolerable_misfit = 0.001;  // error of a frequency caused by eq. 7
constexpr double tolerable_error = 0.001;   // of a frequency, at the verification speeds

}  // namespace

std::string shift_doubts(const Eigen::MatrixX3d& position, const Eigen::MatrixX3d& shift, double speed) {
  const Eigen::VectorXd moved = shift.rowwise().norm();
  Eigen::Index node = 0;
  const double share = moved.cwiseQuotient(position.col(0)).maxCoeff(&node);
  if (share <= largest_shift) return "";
  return text_of("warning: spin moves the tip by ", moved[node], " m at ", speed * rpm_per_rad_s, " rpm, ",
                 100 * share, " % of its radius: are young_modulus [Pa], density [kg/m^3] and the speed right? ");
}

std::string doubts(const ReducedModel& model) {
  const ContactLine& contact = model.contact;
  std::ostringstream text;
  text << shift_doubts(contact.position, contact.static_shift(model.speed_max), model.speed_max);
  const auto& shape = model.verification.shape_balance;
  if (shape && shape->imbalance > shape->tolerance)
    text << "warning: the shape under spin leaves " << 100 * shape->imbalance
         << " % of the load out of balance between its speeds, more than polynomial_tolerance ("
         << 100 * shape->tolerance << " %); ";
  const ModelError error = model_error(model);
  if (error.error > tolerable_error)
    text << "warning: frequencies of the model are off by up to " << 100 * error.error << " % at "
         << error.speed * rpm_per_rad_s
         << " rpm; raise fixed_interface_modes and modes_at_speed, or lower frequency_tolerance; ";
  const double misfit = polynomial_misfit(model).value_or(0);
  if (misfit > tolerable_misfit)
    text << "warning: the shape changes too much for eq. 7 between its speeds, frequencies are off by up to "
         << 100 * misfit
         << " %; lower speed_max_rpm, leave polynomial_speeds at 0, or take prestress = \"linear\", for which eq. 7 "
            "is "
            "exact; ";
  return text.str();
}

}  // namespace tiprub
