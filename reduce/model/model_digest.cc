// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/model_digest.h"

#include <cstdint>

#include "cases/program/digest.h"

namespace tiprub {

namespace {

void add(Digest& digest, const Eigen::MatrixXd& matrix) {
  digest.add(static_cast<std::int64_t>(matrix.rows()));
  digest.add(static_cast<std::int64_t>(matrix.cols()));
  digest.add(matrix.data(), static_cast<std::size_t>(matrix.size()));
}

void add(Digest& digest, const Eigen::MatrixXcd& matrix) {
  add(digest, Eigen::MatrixXd(matrix.real()));
  add(digest, Eigen::MatrixXd(matrix.imag()));
}

}  // namespace

std::string digest(const ReducedModel& model) {
  Digest digest;
  digest.add(model.sector_count);
  digest.add(model.speed_max);
  digest.add(model.modes_at_speed);
  digest.add(model.stiffness_under_spin());
  const ContactLine& contact = model.contact;
  add(digest, Eigen::MatrixXd(contact.position));
  add(digest, Eigen::MatrixXd(contact.normal));
  for (int k = 1; k <= contact.static_shift.highest(); ++k)
    add(digest, Eigen::MatrixXd(contact.static_shift.coefficient(k)));
  add(digest, Eigen::MatrixXd(contact.arc_length));
  if (contact.kind != ContactKind::points) digest.add(contact.kind);
  if (contact.splitter_nodes > 0) digest.add(contact.splitter_nodes);
  for (const NodalDiameterModel& matrices : model.nodal_diameters) {
    for (int k = 0; k <= 2; ++k) add(digest, matrices.K.coefficient(k));
    add(digest, matrices.M);
    for (int k = 3; k <= matrices.K.highest(); ++k) add(digest, matrices.K[k]);
  }
  add(digest, Eigen::MatrixXd(model.verification.speeds));
  add(digest, model.verification.polynomial_misfit);
  for (const auto* frequencies : {&model.verification.unreduced, &model.verification.reduced})
    for (const Eigen::MatrixXd& table : *frequencies) add(digest, table);
  return digest.digits();
}

}  // namespace tiprub
