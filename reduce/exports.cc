// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/exports.h"

#include <cmath>
#include <functional>
#include <iomanip>
#include <limits>
#include <ostream>
#include <regex>
#include <set>

#include "cases/program/errors.h"
#include "cases/program/output_file.h"
#include "cases/program/units.h"
#include "mesh/cells/cell_kind.h"
#include "reduce/model/nodal_diameter.h"

namespace tiprub::reduce {

namespace {

constexpr int number_digits = 13;  // CalculiX reads 20 characters of a number: sign, point, exponent and these

void write_list(std::ostream& out, const std::string& header, const std::vector<int>& nodes,
                const std::set<int>& without) {
  out << header << "\n";
  for (const int node : nodes)
    if (!without.contains(node)) out << node + 1 << ",\n";
}

// A node can be held or tied, not both: the clamp wins, as in SectorDofs.
void write_cut_faces(std::ostream& out, const SectorMesh& mesh) {
  if (mesh.sector_count == 1) return;
  const std::set<int> held(mesh.clamped.begin(), mesh.clamped.end());
  write_list(out, "*NSET, NSET=low", mesh.cyclic_low, held);
  write_list(out, "*NSET, NSET=high", mesh.cyclic_high, held);
  out << "*SURFACE, NAME=low, TYPE=NODE\nlow\n*SURFACE, NAME=high, TYPE=NODE\nhigh\n"
      << "*TIE, NAME=cut, CYCLIC SYMMETRY\nlow, high\n"
      << "*CYCLIC SYMMETRY MODEL, N=" << mesh.sector_count << ", TIE=cut\n0, 0, 0, 0, 0, 1\n";
}

/// Writes the cells of one kind. CalculiX numbers their nodes as VTK does.
void write_cells(std::ostream& out, const SectorMesh& mesh, const CellKind& kind) {
  bool begun = false;
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto nodes = nodes_of(mesh.cells, cell);
    if (nodes.size() != kind.nodes()) continue;
    if (!begun) out << "*ELEMENT, TYPE=" << kind.calculix << ", ELSET=Eall\n";
    begun = true;
    out << cell + 1;
    for (int i = 0; i < kind.nodes(); ++i)  // at most 16 numbers a line
      out << (i == 10 ? ",\n" : ", ") << nodes[i] + 1;
    out << "\n";
  }
}

void write_mesh(std::ostream& out, const SectorMesh& mesh, const ReductionParameters& parameters) {
  out << std::scientific << std::setprecision(number_digits) << "*NODE, NSET=Nall\n";
  for (int node = 0; node < mesh.node_count(); ++node)
    out << node + 1 << ", " << mesh.nodes(0, node) << ", " << mesh.nodes(1, node) << ", " << mesh.nodes(2, node)
        << "\n";
  for (const CellKind& kind : all_cell_kinds()) write_cells(out, mesh, kind);
  write_list(out, "*NSET, NSET=clamped", mesh.clamped, {});
  write_cut_faces(out, mesh);
  out << "*MATERIAL, NAME=metal\n*ELASTIC\n"
      << parameters.material.young << ", " << parameters.material.poisson << "\n*DENSITY\n"
      << parameters.material.density << "\n*SOLID SECTION, ELSET=Eall, MATERIAL=metal\n"
      << "*BOUNDARY\nclamped, 1, 3\n";
}

/// CalculiX stops Newton's method at 0.5 % of the load if it isn't told otherwise. The two numbers are its tolerances
/// R_n of the residual force and C_n of the last correction.
const std::string calculix_controls = "*CONTROLS, PARAMETERS=FIELD\n1e-10, 1e-10\n";

void write_speed(std::ostream& out, double speed, const SectorMesh& mesh, const ReductionParameters& parameters) {
  out << std::scientific << std::setprecision(number_digits) << "*INCLUDE, INPUT=mesh.inp\n";
  const bool nonlinear = parameters.prestress == Prestress::nonlinear;
  if (speed > 0)
    out << (nonlinear ? "*STEP, NLGEOM\n" + calculix_controls + "*STATIC\n1, 1\n" : "*STEP\n*STATIC\n")
        << "*DLOAD\nEall, CENTRIF, " << speed * speed << ", 0, 0, 0, 0, 0, 1\n*END STEP\n"
        << "*STEP, PERTURBATION\n";
  else
    out << "*STEP\n";
  // A travelling wave counts twice in CalculiX, as a cosine and a sine.
  const bool cyclic = mesh.sector_count > 1;
  out << "*FREQUENCY\n" << (cyclic ? 2 : 1) * parameters.verification_modes << "\n";
  if (cyclic) out << "*SELECT CYCLIC SYMMETRY MODES, NMIN=0, NMAX=" << mesh.sector_count / 2 << "\n";
  out << "*END STEP\n";
}

void write_whole(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
  OutputFile output(path);
  write_file(output.scratch(), write);
  output.commit();
}

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

/// CalculiX's stiffness under spin is that of the displaced shape, with spin softening.
void require_known_spin(const ReductionParameters& parameters) {
  if (parameters.verification_speeds.back() == 0) return;
  if (parameters.prestress == Prestress::stress_only)
    throw InputError(
        "[reduce] prestress = \"stress_only\" takes the shape at rest, which CalculiX doesn't do; take "
        "\"linear\" or \"nonlinear\", or leave only 0 in verification_speeds");
  if (parameters.spin_softening == SpinSoftening::off)
    throw InputError(
        "[reduce] spin_softening = false leaves out what CalculiX always has; take true, or leave only 0 "
        "in verification_speeds");
}

/// Of an earlier run: the matrices of another model would pass for coefficients of this one.
void remove_other_matrices(const std::filesystem::path& folder, const std::set<std::filesystem::path>& written) {
  static const std::regex ours("n[0-9]+_(K[0-9]+|M)\\.mtx");
  std::error_code ignored;
  for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path name = entry.path().filename();
    if (!written.contains(name) && std::regex_match(name.string(), ours))
      std::filesystem::remove(entry.path(), ignored);
  }
}

}  // namespace

void write_calculix_decks(const SectorMesh& mesh, const ReductionParameters& parameters,
                          const std::filesystem::path& folder) {
  require_known_spin(parameters);
  if (mesh.cubic != nullptr)
    throw InputError("[reduce] element_order = 3 makes cubic bricks, which CalculiX doesn't have; leave it at 2");
  for (int cell = 0; cell < mesh.cell_count(); ++cell)
    if (const CellKind& kind = cell_kind(static_cast<int>(nodes_of(mesh.cells, cell).size())); kind.calculix.empty())
      throw InputError(mesh.file + ": has cells of kind " + kind.name +
                       ", which CalculiX doesn't have; mesh it with hex20, wedge15 or tet10");
  std::filesystem::create_directories(folder);
  write_whole(folder / "mesh.inp", [&](std::ostream& out) { write_mesh(out, mesh, parameters); });
  for (const double fraction : parameters.verification_speeds) {
    const double speed = fraction * parameters.speed_max;
    const long rpm = std::lround(speed * rpm_per_rad_s);
    write_whole(folder / ("speed_" + std::to_string(rpm) + ".inp"),
                [&](std::ostream& out) { write_speed(out, speed, mesh, parameters); });
  }
}

void write_matrix_market(const ReducedModel& model, const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw RunError(folder.string() + ": can't be made: " + failure.message());
  std::set<std::filesystem::path> written;
  const auto write = [&](const std::string& name, const Eigen::MatrixXcd& matrix, bool standing,
                         const std::string& about) {
    write_whole(folder / name, [&](std::ostream& out) { write_matrix(out, matrix, standing, about); });
    written.insert(name);
  };
  for (std::size_t n = 0; n < model.nodal_diameters.size(); ++n) {
    const NodalDiameterModel& matrices = model.nodal_diameters[n];
    const bool standing = is_standing(static_cast<int>(n), model.sector_count);
    const std::string stem = "n" + std::to_string(n) + "_";
    const std::string about = "nodal diameter " + std::to_string(n) +
                              ", K = K0 + Omega^2 K1 + Omega^4 K2 + ..., rad/s; the first " +
                              std::to_string(model.contact_dofs()) + " dofs are r, theta, z of the contact nodes; ";
    for (int k = 0; k <= matrices.K.highest(); ++k) {
      const std::string name = "K" + std::to_string(k);
      write(stem + name + ".mtx", matrices.K.coefficient(k), standing,
            about + name + " in N/m" + (k == 0 ? "" : " s^" + std::to_string(2 * k)));
    }
    write(stem + "M.mtx", matrices.M, standing, about + "M in kg");
  }
  remove_other_matrices(folder, written);
}

}  // namespace tiprub::reduce
