// SPDX-License-Identifier: GPL-3.0-or-later
#include <iomanip>
#include <numbers>
#include <ostream>

#include "cases/program/units.h"
#include "reduce/linear_results.h"
#include "reduce/model/hdf5_file.h"

namespace tiprub {

namespace {

constexpr const char* schema = "tiprub-modes";
constexpr int schema_version = 1;

double rpm(double speed) {
  return speed * rpm_per_rad_s;
}

void print_modes(std::ostream& out, const LinearResults& results) {
  out << "speed_rpm nodal_diameter mode frequency_hz branch mac";
  for (const std::string& part : results.parts) out << " energy_" << part;
  out << "\n";
  for (int row = 0; row < results.speed_count(); ++row)
    for (std::size_t n = 0; n < results.nodal_diameters.size(); ++n) {
      const ModesOverSpeed& modes = results.nodal_diameters[n];
      for (Eigen::Index k = 0; k < modes.frequency.cols(); ++k) {
        out << std::setprecision(8) << rpm(results.speeds[row]) << " " << n << " " << k + 1 << " "
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
      out << std::setprecision(8) << rpm(results.speeds[row]) << " " << results.parts[part] << std::setprecision(6)
          << " " << results.displacement(row, static_cast<Eigen::Index>(part)) << " "
          << results.von_mises(row, static_cast<Eigen::Index>(part)) << "\n";
}

void print_tip(std::ostream& out, const LinearResults& results) {
  out << "\nspeed_rpm tip_arc_length_m clearance_loss_m\n";
  for (int row = 0; row < results.speed_count(); ++row)
    for (Eigen::Index k = 0; k < results.tip_arc_length.size(); ++k)
      out << std::setprecision(8) << rpm(results.speeds[row]) << std::setprecision(6) << " "
          << results.tip_arc_length[k] << " " << results.clearance_loss(row, k) << "\n";
}

}  // namespace

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

}  // namespace tiprub
