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
  digest.add(model.prestress);
  for (const auto* table :
       {&model.contact.position, &model.contact.normal, &model.contact.static_shift_1, &model.contact.static_shift_2})
    add(digest, Eigen::MatrixXd(*table));
  for (const Eigen::MatrixX3d& shift : model.contact.higher_shifts) add(digest, Eigen::MatrixXd(shift));
  add(digest, Eigen::MatrixXd(model.contact.arc_length));
  if (model.contact.kind != ContactKind::points) digest.add(model.contact.kind);
  if (model.contact.splitter_nodes > 0) digest.add(model.contact.splitter_nodes);
  for (const NodalDiameterModel& matrices : model.nodal_diameters) {
    for (const auto* matrix : {&matrices.K0, &matrices.K1, &matrices.K2, &matrices.M}) add(digest, *matrix);
    for (const Eigen::MatrixXcd& matrix : matrices.higher) add(digest, matrix);
  }
  add(digest, Eigen::MatrixXd(model.verification.speeds));
  add(digest, model.verification.polynomial_misfit);
  for (const auto* frequencies : {&model.verification.unreduced, &model.verification.reduced})
    for (const Eigen::MatrixXd& table : *frequencies) add(digest, table);
  return digest.digits();
}

}  // namespace tiprub
