// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/reduced_model_file.h"

#include "reduce/model/hdf5_file.h"

namespace tiprub {

namespace {

constexpr const char* schema = "tiprub-model";
constexpr int schema_version = 1;

std::string group_of(int nodal_diameter) {
  return "/nodal_diameter/" + std::to_string(nodal_diameter);
}

Eigen::MatrixX3d read_triples(const Hdf5File& file, const std::string& name) {
  const Eigen::MatrixXd table = file.read_matrix(name);
  if (table.cols() != 3) throw RunError(file.path() + ": " + name + " must have three columns: r, theta, z");
  return table;
}

/// A model by hand may leave out what is zero.
Eigen::MatrixX3d read_triples_or_zero(const Hdf5File& file, const std::string& name, Eigen::Index rows) {
  return file.exists(name) ? read_triples(file, name) : Eigen::MatrixX3d(Eigen::MatrixX3d::Zero(rows, 3));
}

Eigen::MatrixXcd read_or_zero(const Hdf5File& file, const std::string& name, const Eigen::MatrixXcd& like) {
  return file.exists(name) ? file.read_complex_matrix(name)
                           : Eigen::MatrixXcd(Eigen::MatrixXcd::Zero(like.rows(), like.cols()));
}

void write_matrix(Hdf5File& file, const std::string& name, const Eigen::MatrixXcd& matrix, const std::string& unit) {
  const bool real = matrix.imag().isZero(0.0);
  if (real)
    file.write(name, Eigen::MatrixXd(matrix.real()), unit);
  else
    file.write(name, matrix, unit);
}

void write_verification(Hdf5File& file, const Verification& verification) {
  if (verification.speeds.size() == 0) return;
  file.write("/verification/speed", verification.speeds, "rad/s");
  if (verification.polynomial_misfit.size() > 0)
    file.write("/verification/polynomial_misfit", verification.polynomial_misfit, "1");
  for (std::size_t n = 0; n < verification.unreduced.size(); ++n) {
    const std::string group = "/verification" + group_of(static_cast<int>(n));
    file.write(group + "/unreduced", verification.unreduced[n], "Hz");
    file.write(group + "/reduced", verification.reduced[n], "Hz");
  }
}

}  // namespace

void write_model(const ReducedModel& model, const std::filesystem::path& path, const std::string& generator) {
  Hdf5File file = Hdf5File::create(path);
  file.set_schema(schema, schema_version, generator);
  file.set_attribute("/", "sector_count", model.sector_count);
  file.set_attribute("/", "speed_max", model.speed_max);
  file.set_attribute("/", "modes_at_speed", model.modes_at_speed);
  file.set_attribute("/", "prestress", model.prestress);
  file.set_attribute("/", "provenance", model.provenance);
  file.write("/contact/position", Eigen::MatrixXd(model.contact.position), "m, rad, m");
  file.write("/contact/normal", Eigen::MatrixXd(model.contact.normal), "1");
  file.write("/contact/arc_length", model.contact.arc_length, "m");
  file.write("/contact/static_shift_1", Eigen::MatrixXd(model.contact.static_shift_1), "m s^2");
  file.write("/contact/static_shift_2", Eigen::MatrixXd(model.contact.static_shift_2), "m s^4");
  for (std::size_t n = 0; n < model.nodal_diameters.size(); ++n) {
    const NodalDiameterModel& matrices = model.nodal_diameters[n];
    const std::string group = group_of(static_cast<int>(n));
    write_matrix(file, group + "/K0", matrices.K0, "N/m");
    write_matrix(file, group + "/K1", matrices.K1, "N/m s^2");
    write_matrix(file, group + "/K2", matrices.K2, "N/m s^4");
    for (std::size_t k = 0; k < matrices.higher.size(); ++k)
      write_matrix(file, group + "/K" + std::to_string(3 + k), matrices.higher[k],
                   "N/m s^" + std::to_string(2 * (3 + k)));
    write_matrix(file, group + "/M", matrices.M, "kg");
  }
  write_verification(file, model.verification);
  file.close();
}

ReducedModel read_model(const std::filesystem::path& path) {
  const Hdf5File file = Hdf5File::open(path);
  file.require_schema(schema, schema_version);
  ReducedModel model;
  model.sector_count = file.integer_attribute("/", "sector_count");
  model.speed_max = file.number_attribute("/", "speed_max");
  if (file.has_attribute("/", "modes_at_speed")) model.modes_at_speed = file.integer_attribute("/", "modes_at_speed");
  model.prestress = file.has_attribute("/", "prestress") ? file.text_attribute("/", "prestress") : "given";
  if (file.has_attribute("/", "provenance")) model.provenance = file.text_attribute("/", "provenance");
  model.contact.arc_length = file.read_vector("/contact/arc_length");
  const Eigen::Index contact_count = model.contact.arc_length.size();
  model.contact.position = read_triples(file, "/contact/position");
  model.contact.normal = read_triples(file, "/contact/normal");
  model.contact.static_shift_1 = read_triples_or_zero(file, "/contact/static_shift_1", contact_count);
  model.contact.static_shift_2 = read_triples_or_zero(file, "/contact/static_shift_2", contact_count);
  for (int n = 0; n <= model.nodal_diameter_max(); ++n) {
    const std::string group = group_of(n);
    NodalDiameterModel matrices;
    matrices.M = file.read_complex_matrix(group + "/M");
    matrices.K0 = file.read_complex_matrix(group + "/K0");
    matrices.K1 = read_or_zero(file, group + "/K1", matrices.M);
    matrices.K2 = read_or_zero(file, group + "/K2", matrices.M);
    for (int k = 3; file.exists(group + "/K" + std::to_string(k)); ++k)
      matrices.higher.push_back(file.read_complex_matrix(group + "/K" + std::to_string(k)));
    model.nodal_diameters.push_back(std::move(matrices));
  }
  if (file.exists("/verification/speed")) {
    model.verification.speeds = file.read_vector("/verification/speed");
    if (file.exists("/verification/polynomial_misfit"))
      model.verification.polynomial_misfit = file.read_matrix("/verification/polynomial_misfit");
    for (int n = 0; n <= model.nodal_diameter_max(); ++n) {
      model.verification.unreduced.push_back(file.read_matrix("/verification" + group_of(n) + "/unreduced"));
      model.verification.reduced.push_back(file.read_matrix("/verification" + group_of(n) + "/reduced"));
    }
  }
  check(model, path.string());
  return model;
}

}  // namespace tiprub
