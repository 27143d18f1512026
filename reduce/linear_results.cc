// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/linear_results.h"

#include <algorithm>
#include <iomanip>
#include <numeric>
#include <ostream>
#include <utility>

#include "cases/program/units.h"
#include "mesh/cells/cell_kind.h"
#include "reduce/basis/cyclic_modes.h"
#include "reduce/model/hdf5_file.h"
#include "reduce/model/reduced_model.h"
#include "reduce/operators/memory_need.h"
#include "reduce/operators/speed_samples.h"
#include "reduce/operators/spin_equilibrium.h"
#include "reduce/sector/contact_line.h"
#include "reduce/sector/parallel_for.h"

namespace tiprub::reduce {

namespace {

constexpr double mode_tolerance = 1e-5;  // residual of 1/omega^2; the error of a frequency goes with its square
constexpr int krylov_vectors = 12;       // for each wanted mode, with their products
constexpr double least_mac = 0.5;        // between modes of one branch

/// The parts of a sector, or the whole sector as one part if the mesh names none.
std::map<std::string, std::vector<int>> parts_of(const SectorMesh& mesh) {
  if (!mesh.parts.empty()) return mesh.parts;
  std::vector<int> all(mesh.cell_count());
  std::iota(all.begin(), all.end(), 0);
  return {{"sector", all}};
}

/// For each mode now (rows of `mac`), the mode before that it continues, or -1.
std::vector<int> pair_by_mac(Eigen::MatrixXd mac) {
  std::vector<int> partner(mac.rows(), -1);
  for (Eigen::Index pair = 0; pair < std::min(mac.rows(), mac.cols()); ++pair) {
    Eigen::Index now = 0, before = 0;
    if (mac.maxCoeff(&now, &before) < least_mac) break;
    partner[now] = static_cast<int>(before);
    mac.row(now).setConstant(-1);
    mac.col(before).setConstant(-1);
  }
  return partner;
}

class LinearAnalysis {
 public:
  LinearAnalysis(const SectorMesh& mesh, const ReductionParameters& parameters, FactorChoice factors)
      : mesh_(mesh),
        parameters_(parameters),
        factors_(std::move(factors)),
        parts_(parts_of(mesh)),
        contact_(mesh.contact_line),
        dofs_(number_dofs(mesh, std::vector<int>())),
        elasticity_(mesh, dofs_, parameters.material, parameters.threads),
        mass_(elasticity_.mass()) {
    for (int n = 0; n <= mesh.sector_count / 2; ++n) transforms_.emplace_back(dofs_, mesh.sector_count, n);
    shapes_.resize(transforms_.size());
  }

  LinearResults run() {
    prepare();
    find_shapes();
    for (int row = 0; row < results_.speed_count(); ++row) {
      static_state(row);
      if (results_.speeds[row] > 0) solve_modes(row, factorize(row));
      share_energy(row);
    }
    return std::move(results_);
  }

 private:
  void prepare() {
    results_.sector_count = mesh_.sector_count;
    results_.sector_dofs = dofs_.sector();
    results_.prestress = name_in(prestress_names, parameters_.prestress);
    const std::vector<double>& fractions = parameters_.verification_speeds;
    results_.speeds = parameters_.speed_max * Eigen::Map<const Eigen::VectorXd>(fractions.data(), fractions.size());
    const Eigen::Index speeds = results_.speeds.size(), modes = parameters_.verification_modes;
    for (const auto& [name, cells] : parts_) results_.parts.push_back(name);
    const ModesOverSpeed empty = {Eigen::MatrixXd(speeds, modes), Eigen::MatrixXi(speeds, modes),
                                  Eigen::MatrixXd::Ones(speeds, modes),
                                  std::vector<Eigen::MatrixXd>(parts_.size(), Eigen::MatrixXd(speeds, modes))};
    results_.nodal_diameters.assign(transforms_.size(), empty);
    results_.displacement = results_.von_mises =
        Eigen::MatrixXd::Zero(speeds, static_cast<Eigen::Index>(parts_.size()));
    tip_ = describe_contact(mesh_, contact_);
    results_.tip_arc_length = tip_.arc_length;
    results_.clearance_loss = Eigen::MatrixXd::Zero(speeds, tip_.size());
  }

  /// Finds the shapes under spin. If rest is among the speeds, its modes are found here too, because they use the
  /// same factor.
  void find_shapes() {
    const SectorFactor factor(
        elasticity_.stiffness(0.0, Eigen::Matrix3Xd::Zero(3, mesh_.node_count()), parameters_.prestress), dofs_,
        factors_);
    static_ = shapes_under_spin({elasticity_, mesh_, CyclicSolver(factor, transforms_[0])},
                                {results_.speeds.begin(), results_.speeds.end()}, parameters_.prestress);
    for (int row = 0; row < results_.speed_count() && results_.speeds[row] == 0; ++row) solve_modes(row, factor);
  }

  Eigen::Matrix3Xd displacement(int row) const {
    return cartesian_displacement(mesh_, dofs_, static_.at.at(results_.speeds[row]));
  }

  void static_state(int row) {
    const Eigen::Matrix3Xd u = displacement(row);
    const Eigen::VectorXd stress = elasticity_.von_mises(u, parameters_.prestress);
    Eigen::Index part = 0;
    for (const auto& [name, cells] : parts_) {
      for (const int cell : cells) {
        results_.von_mises(row, part) = std::max(results_.von_mises(row, part), stress[cell]);
        for (const int node : nodes_of(mesh_.cells, cell))
          results_.displacement(row, part) = std::max(results_.displacement(row, part), u.col(node).norm());
      }
      ++part;
    }
    Eigen::MatrixX3d shift(tip_.size(), 3);
    for (int k = 0; k < tip_.size(); ++k)
      shift.row(k) = (cylindrical_frame(mesh_.nodes.col(contact_[k])).transpose() * u.col(contact_[k])).transpose();
    results_.clearance_loss.row(row) = tip_.normal.cwiseProduct(shift).rowwise().sum().transpose();
    results_.doubts = shift_doubts(tip_.position, shift, results_.speeds[row]);
  }

  SectorFactor factorize(int row) const {
    return at_speed(results_.speeds[row], [&] {
      return SectorFactor(elasticity_.stiffness(results_.speeds[row], displacement(row), parameters_.prestress,
                                                parameters_.spin_softening),
                          dofs_, factors_);
    });
  }

  void solve_modes(int row, const SectorFactor& factor) {
    at_speed(results_.speeds[row], [&] {
      parallel_for(static_cast<int>(transforms_.size()), parameters_.threads, [&](int n) {
        const CyclicModes modes = lowest_modes(CyclicSolver(factor, transforms_[n]), mass_, ContactNodes::free,
                                               parameters_.verification_modes, mode_tolerance);
        results_.nodal_diameters[n].frequency.row(row) = modes.frequencies().transpose();
        follow(modes.shape, n, row);
      });
    });
  }

  /// Shares out the energy of the modes found last. The stiffness of a part is assembled when the factor is released,
  /// because both are large.
  void share_energy(int row) {
    Eigen::Index part = 0;
    for (const auto& [name, cells] : parts_) {
      const SymmetricMatrix stiffness = elasticity_.stiffness_of(cells);
      for (std::size_t n = 0; n < transforms_.size(); ++n) {
        const Eigen::MatrixXcd force = transforms_[n].apply(stiffness, shapes_[n]);
        results_.nodal_diameters[n].energy_share[part].row(row) =
            shapes_[n].conjugate().cwiseProduct(force).colwise().sum().real();
      }
      ++part;
    }
    for (ModesOverSpeed& modes : results_.nodal_diameters) {
      Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(modes.frequency.cols());
      for (const Eigen::MatrixXd& share : modes.energy_share) sum += share.row(row);
      for (Eigen::MatrixXd& share : modes.energy_share) share.row(row).array() /= sum.array();
    }
  }

  void follow(const Eigen::MatrixXcd& shape, int n, int row) {
    ModesOverSpeed& modes = results_.nodal_diameters[n];
    if (row == 0) {
      modes.branch.row(0).setLinSpaced(shape.cols(), 0, static_cast<int>(shape.cols()) - 1);
    } else {
      const Eigen::MatrixXd mac = (transforms_[n].apply(mass_, shape).adjoint() * shapes_[n]).cwiseAbs2();
      const std::vector<int> partner = pair_by_mac(mac);
      int next = modes.branch.topRows(row).maxCoeff() + 1;
      for (Eigen::Index k = 0; k < shape.cols(); ++k) {
        const int before = partner[k];
        modes.branch(row, k) = before < 0 ? next++ : modes.branch(row - 1, before);
        if (before >= 0) modes.mac(row, k) = mac(k, before);
      }
    }
    shapes_[n] = shape;
  }

  const SectorMesh& mesh_;
  const ReductionParameters& parameters_;
  FactorChoice factors_;
  std::map<std::string, std::vector<int>> parts_;
  std::vector<int> contact_;  // all nodes of the tip line
  SectorDofs dofs_;
  RotatingElasticity elasticity_;
  SymmetricMatrix mass_;
  std::vector<CyclicTransformation> transforms_;
  ContactLine tip_;
  SpinShapes static_;
  std::vector<Eigen::MatrixXcd> shapes_;  // at the speed before, by nodal diameter
  LinearResults results_;
};

constexpr const char* schema = "tiprub-modes";
constexpr int schema_version = 1;

void print_modes(std::ostream& out, const LinearResults& results) {
  out << "speed_rpm nodal_diameter mode frequency_hz branch mac";
  for (const std::string& part : results.parts) out << " energy_" << part;
  out << "\n";
  for (int row = 0; row < results.speed_count(); ++row)
    for (std::size_t n = 0; n < results.nodal_diameters.size(); ++n) {
      const ModesOverSpeed& modes = results.nodal_diameters[n];
      for (Eigen::Index k = 0; k < modes.frequency.cols(); ++k) {
        out << std::setprecision(8) << results.speeds[row] * rpm_per_rad_s << " " << n << " " << k + 1 << " "
            << modes.frequency(row, k) << std::setprecision(4) << " " << modes.branch(row, k) + 1 << " "
            << modes.mac(row, k);
        for (const Eigen::MatrixXd& share : modes.energy_share) out << " " << share(row, k);
        out << "\n";
      }
    }
}

void print_static_state(std::ostream& out, const LinearResults& results) {
  out << "\nspeed_rpm part displacement_m von_mises_pa\n";
  for (int row = 0; row < results.speed_count(); ++row)
    for (std::size_t part = 0; part < results.parts.size(); ++part)
      out << std::setprecision(8) << results.speeds[row] * rpm_per_rad_s << " " << results.parts[part]
          << std::setprecision(6) << " " << results.displacement(row, static_cast<Eigen::Index>(part)) << " "
          << results.von_mises(row, static_cast<Eigen::Index>(part)) << "\n";
}

void print_tip(std::ostream& out, const LinearResults& results) {
  out << "\nspeed_rpm tip_arc_length_m clearance_loss_m\n";
  for (int row = 0; row < results.speed_count(); ++row)
    for (Eigen::Index k = 0; k < results.tip_arc_length.size(); ++k)
      out << std::setprecision(8) << results.speeds[row] * rpm_per_rad_s << std::setprecision(6) << " "
          << results.tip_arc_length[k] << " " << results.clearance_loss(row, k) << "\n";
}

}  // namespace

LinearResults linear_results(const SectorMesh& mesh, const ReductionParameters& parameters) {
  const MemoryNeed need = memory_need(mesh, number_dofs(mesh, std::vector<int>()),
                                      {.factors = 1,
                                       .stiffnesses = 1,
                                       .columns = krylov_vectors * parameters.verification_modes,
                                       .threads = parameters.threads});
  const FactorMethod method = choose_method(need, parameters);
  start_threads(need, method, parameters.threads);
  return LinearAnalysis(mesh, parameters, {method, parameters.scratch_folder}).run();
}

void print(std::ostream& out, const LinearResults& results) {
  print_modes(out, results);
  print_static_state(out, results);
  print_tip(out, results);
}

void write_linear_results(const LinearResults& results, const std::filesystem::path& path,
                          const std::string& generator, const std::string& provenance) {
  Hdf5File file = Hdf5File::create(path);
  file.set_schema(schema, schema_version, generator);
  file.set_attribute("/", "sector_count", results.sector_count);
  file.set_attribute("/", "prestress", results.prestress);
  file.write_text("/provenance", provenance);
  file.write("/speed", results.speeds, "rad/s");
  for (std::size_t n = 0; n < results.nodal_diameters.size(); ++n) {
    const std::string group = "/nodal_diameter/" + std::to_string(n);
    const ModesOverSpeed& modes = results.nodal_diameters[n];
    file.write(group + "/frequency", modes.frequency, "Hz");
    file.write(group + "/branch", Eigen::MatrixXd(modes.branch.cast<double>()), "1");
    file.write(group + "/mac", modes.mac, "1");
    for (std::size_t part = 0; part < results.parts.size(); ++part)
      file.write(group + "/energy_share/" + results.parts[part], modes.energy_share[part], "1");
  }
  for (std::size_t part = 0; part < results.parts.size(); ++part) {
    const auto column = static_cast<Eigen::Index>(part);
    file.write("/static/displacement/" + results.parts[part], Eigen::VectorXd(results.displacement.col(column)), "m");
    file.write("/static/von_mises/" + results.parts[part], Eigen::VectorXd(results.von_mises.col(column)), "Pa");
  }
  file.write("/tip/arc_length", results.tip_arc_length, "m");
  file.write("/tip/clearance_loss", results.clearance_loss, "m");
  file.close();
}

}  // namespace tiprub::reduce
