// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/matrix_market.h"

#include <iomanip>
#include <limits>
#include <ostream>
#include <string>

#include "cases/program/errors.h"
#include "cases/program/output_file.h"
#include "reduce/model/nodal_diameter.h"

namespace tiprub {

namespace {

void write_matrix(std::ostream& out, const Eigen::MatrixXcd& matrix, bool real, const std::string& comment) {
  out << "%%MatrixMarket matrix array " << (real ? "real symmetric" : "complex hermitian") << "\n% " << comment
      << "\n"
      << matrix.rows() << " " << matrix.cols() << "\n"
      << std::scientific << std::setprecision(std::numeric_limits<double>::max_digits10 - 1);
  for (Eigen::Index column = 0; column < matrix.cols(); ++column)
    for (Eigen::Index row = column; row < matrix.rows(); ++row) {
      out << matrix(row, column).real();
      if (!real) out << " " << (row == column ? 0.0 : matrix(row, column).imag());
      out << "\n";
    }
}

void write_matrix(const std::filesystem::path& path, const Eigen::MatrixXcd& matrix, bool real,
                  const std::string& comment) {
  OutputFile output(path);
  write_file(output.scratch(), [&](std::ostream& out) { write_matrix(out, matrix, real, comment); });
  output.commit();
}

}  // namespace

void write_matrix_market(const ReducedModel& model, const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw RunError(folder.string() + ": can't be made: " + failure.message());
  for (std::size_t n = 0; n < model.nodal_diameters.size(); ++n) {
    const NodalDiameterModel& matrices = model.nodal_diameters[n];
    const bool standing = is_standing(static_cast<int>(n), model.sector_count);
    const std::string stem = "n" + std::to_string(n) + "_";
    const std::string about = "nodal diameter " + std::to_string(n) +
                              ", K = K0 + Omega^2 K1 + Omega^4 K2 + ..., rad/s; the first " +
                              std::to_string(model.contact_dofs()) + " dofs are r, theta, z of the contact nodes; ";
    for (int k = 0; k <= matrices.K.highest(); ++k) {
      const std::string name = "K" + std::to_string(k);
      write_matrix(folder / (stem + name + ".mtx"), matrices.K.coefficient(k), standing,
                   about + name + " in N/m" + (k == 0 ? "" : " s^" + std::to_string(2 * k)));
    }
    write_matrix(folder / (stem + "M.mtx"), matrices.M, standing, about + "M in kg");
  }
}

}  // namespace tiprub
