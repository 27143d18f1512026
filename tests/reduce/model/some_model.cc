// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reduce/model/some_model.h"

namespace tiprub::reduce::test {

ReducedModel some_model() {
  ReducedModel model;
  model.sector_count = 4;
  model.speed_max = 1234.5;
  model.prestress = Prestress::nonlinear;
  model.spin_softening = SpinSoftening::off;
  model.effects = {{Effect::spin_stiffness, Treatment::simplified, "eq. 7", 1e-4, 1e-3},
                   {Effect::coriolis, Treatment::left_out, "no gyroscopic terms"}};
  model.mesh_digest = "0123456789abcdef";
  model.provenance = "[mesh]\nfamily = \"impeller\"  # \xc3\xa9t\xc3\xa9\n";
  model.contact.position = Eigen::RowVector3d(0.1, -0.2, 1.0 / 3);
  model.contact.normal = Eigen::RowVector3d(0.6, 0.0, -0.8);
  model.contact.arc_length = Eigen::VectorXd::Zero(1);
  model.contact.static_shift.terms = {Eigen::RowVector3d(1e-12, 2e-13, -3e-14),
                                      Eigen::RowVector3d(1e-20, 0.0, 7e-21)};
  for (int n = 0; n <= 2; ++n) {
    Eigen::MatrixXcd skew = Eigen::MatrixXcd::Zero(5, 5);
    if (n == 1) {
      skew(0, 4) = {0.25, 1.0 / 7};
      skew(4, 0) = std::conj(skew(0, 4));
    }
    const Eigen::MatrixXcd one = Eigen::MatrixXcd::Identity(5, 5);
    model.nodal_diameters.push_back(
        {{{1e6 * (n + 2) * one + 1e5 * skew, 0.1 * one + 0.01 * skew, 1e-9 * one}}, one + skew});
  }
  model.verification.shape_balance = ShapeBalance{1e-5, 1e-4};
  model.verification.speeds = Eigen::Vector2d(0.0, 1234.5);
  model.verification.unreduced.assign(3, Eigen::MatrixXd::Constant(2, 4, 100.0 / 3));
  model.verification.reduced.assign(3, Eigen::MatrixXd::Constant(2, 4, 101.0 / 3));
  return model;
}

void write_one_mass(Hdf5File& file, const std::string& arc_unit) {
  file.set_schema("tiprub-model", 1, "by hand");
  file.set_attribute("/", "sector_count", 1);
  file.set_attribute("/", "speed_max", 100.0);
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(3, 3);
  file.write("/contact/position", Eigen::MatrixXd(one.topRows(1)), "m, rad, m");
  file.write("/contact/normal", Eigen::MatrixXd(one.topRows(1)), "1");
  file.write("/contact/arc_length", Eigen::VectorXd(Eigen::VectorXd::Zero(1)), arc_unit);
  file.write("/nodal_diameter/0/K0", Eigen::MatrixXd(4 * one), "N/m");
  file.write("/nodal_diameter/0/M", one, "kg");
}

}  // namespace tiprub::reduce::test
