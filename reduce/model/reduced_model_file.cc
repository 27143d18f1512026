// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/reduced_model_file.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "cases/program/text.h"
#include "reduce/model/condensation.h"
#include "reduce/model/hdf5_file.h"

namespace tiprub {

namespace {

constexpr const char* model_schema = "tiprub-model";
constexpr int model_schema_version = 1;
constexpr const char* position_unit = "m, rad, m";
constexpr const char* blade_name = "/contact/blade";
constexpr const char* second_order_group = "/contact/second_order";
constexpr const char* mesh_error_group = "/mesh_error";

std::string group_of(int nodal_diameter) {
  return "/nodal_diameter/" + std::to_string(nodal_diameter);
}

/// "N/m s^2" of K1, with Omega^2.
std::string stiffness_unit(int power) {
  return power == 0 ? "N/m" : "N/m s^" + std::to_string(2 * power);
}

/// "m s^2" of the shape's part with Omega^2, the first.
std::string shift_unit(int power) {
  return "m s^" + std::to_string(2 * power);
}

constexpr const char* shift_stem = "/contact/static_shift_";

std::string shift_name(int power) {
  return shift_stem + std::to_string(power);
}

/// A model made by hand may leave units out, but must not use others.
void require_unit(const Hdf5File& file, const std::string& name, const std::string& unit) {
  if (!file.has_attribute(name, "unit")) return;
  if (const std::string found = file.text_attribute(name, "unit"); found != unit)
    file.refuse(name, " has the unit \"", found, "\", must be \"", unit, "\" (SI), or no attribute `unit`");
}

Eigen::MatrixX3d read_triples(const Hdf5File& file, const std::string& name, const std::string& unit) {
  require_unit(file, name, unit);
  const Eigen::MatrixXd table = file.read_matrix(name);
  if (table.cols() != 3) file.refuse(name, " must have three columns: r, theta, z");
  return table;
}

/// A model made by hand may leave out terms that are zero.
void read_static_shift(const Hdf5File& file, ContactLine& contact) {
  const Eigen::MatrixX3d zero = Eigen::MatrixX3d::Zero(contact.arc_length.size(), 3);
  std::set<std::string> known;
  for (int k = 1; k <= 2 || file.exists(shift_name(k)); ++k) {
    const std::string name = shift_name(k);
    contact.static_shift.terms.push_back(file.exists(name) ? read_triples(file, name, shift_unit(k)) : zero);
    known.insert(name);
  }
  for (const std::string& member : file.members("/contact"))
    if (const std::string name = "/contact/" + member; name.starts_with(shift_stem) && !known.contains(name))
      file.refuse(name, " is not known; the static shift is static_shift_1, _2, and _3, _4, ... without a gap");
}

Eigen::MatrixXcd read_matrix(const Hdf5File& file, const std::string& name, const std::string& unit) {
  Eigen::MatrixXcd matrix = file.read_complex_matrix(name);
  require_unit(file, name, unit);
  return matrix;
}

/// Refuses members of other names, which would otherwise be ignored without a message.
void require_known_members(const Hdf5File& file, const std::string& group) {
  std::set<std::string> known = {"M", "K0", "K1", "K2"};
  for (int k = 3; file.exists(group + "/K" + std::to_string(k)); ++k) known.insert("K" + std::to_string(k));
  for (const std::string& name : file.members(group))
    if (!known.contains(name))
      file.refuse(group, "/", name,
                  " is not known; a nodal diameter holds M, K0, K1, K2, and K3, K4, ... without a gap");
}

NodalDiameterModel read_nodal_diameter(const Hdf5File& file, const std::string& group) {
  if (file.exists(group)) require_known_members(file, group);
  NodalDiameterModel matrices;
  matrices.M = read_matrix(file, group + "/M", "kg");
  const Eigen::MatrixXcd zero = Eigen::MatrixXcd::Zero(matrices.M.rows(), matrices.M.cols());
  const auto name = [&](int k) { return group + "/K" + std::to_string(k); };
  for (int k = 0; k <= 2 || file.exists(name(k)); ++k)
    matrices.K.terms.push_back(k == 0 || file.exists(name(k)) ? read_matrix(file, name(k), stiffness_unit(k)) : zero);
  return matrices;
}

/// A model made by hand may leave both out. Older files name the softening in the text of the prestress.
void read_stiffness_under_spin(const Hdf5File& file, ReducedModel& model) {
  if (file.has_attribute("/", "spin_softening"))
    model.spin_softening = file.named_attribute("/", "spin_softening", softening_names);
  if (file.has_attribute("/", "prestress")) {
    std::string prestress = file.text_attribute("/", "prestress");
    if (prestress.ends_with(without_spin_softening)) {
      prestress.resize(prestress.size() - std::string_view(without_spin_softening).size());
      model.spin_softening = SpinSoftening::off;
    }
    model.prestress = value_named(prestress_names, prestress, file.path() + ": attribute prestress");
  }
}

/// How many of the contact nodes stand on the splitter: those after the main blade's.
int read_splitter_nodes(const Hdf5File& file, int nodes) {
  const Eigen::VectorXd blade = file.read_vector(blade_name);
  const auto on_splitter = static_cast<int>((blade.array() == 1.0).count());
  const bool in_order =
      blade.size() == nodes && on_splitter < nodes && (blade.head(nodes - on_splitter).array() == 0.0).all();
  if (!in_order)
    file.refuse(blade_name, " must hold, for each of the ", nodes,
                " contact nodes, 0 for those of the main blade, which come first, and 1 for the splitter's");
  return on_splitter;
}

/// n_c x p x p
std::vector<Eigen::MatrixXd> read_displacement(const Hdf5File& file, const std::string& name) {
  const Array<double> array = file.read_array(name);
  if (array.shape.size() != 3) file.refuse(name, " must have three axes: n_c x p x p");
  const auto rows = static_cast<Eigen::Index>(array.shape[1]), columns = static_cast<Eigen::Index>(array.shape[2]);
  std::vector<Eigen::MatrixXd> matrices;
  for (std::size_t k = 0; k < array.shape[0]; ++k)
    matrices.emplace_back(Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
        array.values.data() + static_cast<Eigen::Index>(k) * rows * columns, rows, columns));
  return matrices;
}

SecondOrderGap read_second_order(const Hdf5File& file) {
  const std::string group = second_order_group;
  for (const auto& [name, unit] : {std::pair("/curvature", "1/m"), std::pair("/V", "1"), std::pair("/Q", "1/m")})
    require_unit(file, group + name, unit);
  const Eigen::MatrixXd curvature = file.read_matrix(group + "/curvature");
  if (curvature.cols() != 2) file.refuse(group, "/curvature must have two columns: around and along the casing");
  return {curvature, file.read_matrix(group + "/V"), read_displacement(file, group + "/Q")};
}

ContactLine read_contact_line(const Hdf5File& file) {
  ContactLine contact;
  if (file.has_attribute("/", "contact")) contact.kind = file.named_attribute("/", "contact", contact_kind_names);
  contact.arc_length = file.read_vector("/contact/arc_length");
  require_unit(file, "/contact/arc_length", "m");
  contact.position = read_triples(file, "/contact/position", position_unit);
  contact.normal = read_triples(file, "/contact/normal", "1");
  read_static_shift(file, contact);
  if (file.exists(blade_name)) contact.splitter_nodes = read_splitter_nodes(file, contact.size());
  if (file.exists(second_order_group)) contact.second_order = read_second_order(file);
  return contact;
}

Verification read_verification(const Hdf5File& file, int nodal_diameter_max) {
  Verification verification;
  if (file.exists("/verification") && file.has_attribute("/verification", "shape_imbalance"))
    verification.shape_balance = ShapeBalance{file.number_attribute("/verification", "shape_imbalance"),
                                              file.number_attribute("/verification", "shape_tolerance")};
  if (!file.exists("/verification/speed")) return verification;
  verification.speeds = file.read_vector("/verification/speed");
  if (file.exists("/verification/polynomial_misfit"))
    verification.polynomial_misfit = file.read_matrix("/verification/polynomial_misfit");
  for (int n = 0; n <= nodal_diameter_max; ++n) {
    verification.unreduced.push_back(file.read_matrix("/verification" + group_of(n) + "/unreduced"));
    verification.reduced.push_back(file.read_matrix("/verification" + group_of(n) + "/reduced"));
  }
  return verification;
}

std::optional<MeshError> read_mesh_error(const Hdf5File& file) {
  const std::string group = mesh_error_group;
  if (!file.exists(group)) return std::nullopt;
  for (const char* name : {"/frequency", "/compliance"}) require_unit(file, group + name, "1");
  return MeshError{file.read_matrix(group + "/frequency"), file.read_vector(group + "/compliance")};
}

/// The frequencies that verify a model of one's own must be those of its matrices.
void require_own_frequencies(const ReducedModel& model, std::size_t n, Eigen::Index row, const std::string& path) {
  constexpr double tolerance = 0.01, of_highest = 1e-3;
  const double speed = model.verification.speeds[row];
  const Eigen::RowVectorXd told = model.verification.reduced[n].row(row);
  const Eigen::VectorXd found =
      condense(model.nodal_diameters[n], speed, model.contact_dofs(), model.modes_at_speed).natural_frequencies();
  for (Eigen::Index mode = 0; mode < std::min(told.size(), found.size()); ++mode) {
    if (std::abs(found[mode] - told[mode]) <= std::max(tolerance * told[mode], of_highest * told.maxCoeff()))
      continue;
    throw FileError(text_of(path, ": /verification", group_of(static_cast<int>(n)), "/reduced has ", told[mode],
                            " Hz for mode ", mode, " at ", speed, " rad/s, but K and M of this nodal diameter give ",
                            found[mode], " Hz; correct what is wrong, or leave out /verification"));
  }
}

void require_own_frequencies(const ReducedModel& model, const std::string& path) {
  const Eigen::Index rows = model.verification.speeds.size();
  for (std::size_t n = 0; rows > 0 && n < model.nodal_diameters.size(); ++n)
    for (const Eigen::Index row : std::set<Eigen::Index>{0, rows - 1}) require_own_frequencies(model, n, row, path);
}

/// Angles in degrees are also told by a tip that seems to turn by more than a quarter from node to node.
void require_radians(const ContactLine& contact, const std::string& path) {
  constexpr double turn = 2 * std::numbers::pi;
  for (Eigen::Index k = 1; k < contact.size(); ++k) {
    const double before = contact.position(k - 1, 1), theta = contact.position(k, 1);
    if (k == contact.trailing_edge() + 1 || std::abs(std::remainder(theta - before, turn)) <= turn / 4) continue;
    throw FileError(text_of(path, ": /contact/position: theta goes from ", before, " rad in row ", k - 1, " to ",
                            theta, " rad in the next, more than a quarter of a turn: is it in degrees?"));
  }
}

/// A digest says that a program wrote these numbers and that they belong together. Those of a model by hand are
/// compared with each other.
void require_whole(const Hdf5File& file, const ReducedModel& model) {
  if (!file.has_attribute("/", "digest")) {
    require_radians(model.contact, file.path());
    return require_own_frequencies(model, file.path());
  }
  if (file.text_attribute("/", "digest") != digest(model))
    file.refuse(
        "its numbers are not those that were written (attribute `digest`): it was damaged or changed; "
        "reduce again, or delete that attribute if the change was meant");
}

void write_matrix(Hdf5File& file, const std::string& name, const Eigen::MatrixXcd& matrix, const std::string& unit) {
  const bool real = matrix.imag().isZero(0.0);
  if (real)
    file.write(name, Eigen::MatrixXd(matrix.real()), unit);
  else
    file.write(name, matrix, unit);
}

void write_second_order(Hdf5File& file, const SecondOrderGap& gap) {
  const std::string group = second_order_group;
  const auto p = static_cast<std::size_t>(gap.displacement.front().rows());
  Array<double> displacement{{gap.displacement.size(), p, p}, {}};
  for (const Eigen::MatrixXd& Q : gap.displacement)  // symmetric: by rows as by columns
    displacement.values.insert(displacement.values.end(), Q.data(), Q.data() + Q.size());
  file.write(group + "/curvature", Eigen::MatrixXd(gap.curvature), "1/m");
  file.write(group + "/V", gap.coordinates, "1");
  file.write(group + "/Q", displacement, "1/m");
}

void write_contact_line(Hdf5File& file, const ContactLine& contact) {
  file.write("/contact/position", Eigen::MatrixXd(contact.position), position_unit);
  file.write("/contact/normal", Eigen::MatrixXd(contact.normal), "1");
  file.write("/contact/arc_length", contact.arc_length, "m");
  if (contact.splitter_nodes > 0) {
    Eigen::VectorXd blade = Eigen::VectorXd::Zero(contact.size());
    blade.tail(contact.splitter_nodes).setOnes();
    file.write(blade_name, blade, "1");
  }
  for (int k = 1; k <= contact.static_shift.highest(); ++k)
    file.write(shift_name(k), Eigen::MatrixXd(contact.static_shift.coefficient(k)), shift_unit(k));
  if (contact.second_order) write_second_order(file, *contact.second_order);
}

void write_verification(Hdf5File& file, const Verification& verification) {
  if (const auto& shape = verification.shape_balance) {
    file.set_attribute("/verification", "shape_imbalance", shape->imbalance);
    file.set_attribute("/verification", "shape_tolerance", shape->tolerance);
  }
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
  file.set_schema(model_schema, model_schema_version, generator);
  file.set_attribute("/", "sector_count", model.sector_count);
  file.set_attribute("/", "speed_max", model.speed_max);
  file.set_attribute("/", "modes_at_speed", model.modes_at_speed);
  file.set_attribute("/", "prestress", name_in(prestress_names, model.prestress));
  file.set_attribute("/", "spin_softening", name_in(softening_names, model.spin_softening));
  file.set_attribute("/", "contact", name_in(contact_kind_names, model.contact.kind));
  file.write_text("/provenance", model.provenance);
  file.set_attribute("/", "digest", digest(model));
  if (!model.mesh_digest.empty()) file.set_attribute("/", "mesh_digest", model.mesh_digest);
  write_effects(file, model.effects);
  write_contact_line(file, model.contact);
  for (std::size_t n = 0; n < model.nodal_diameters.size(); ++n) {
    const NodalDiameterModel& matrices = model.nodal_diameters[n];
    const std::string group = group_of(static_cast<int>(n));
    for (int k = 0; k <= matrices.K.highest(); ++k)
      write_matrix(file, group + "/K" + std::to_string(k), matrices.K.coefficient(k), stiffness_unit(k));
    write_matrix(file, group + "/M", matrices.M, "kg");
  }
  write_verification(file, model.verification);
  if (model.mesh_error) {
    file.write(std::string(mesh_error_group) + "/frequency", model.mesh_error->frequency, "1");
    file.write(std::string(mesh_error_group) + "/compliance", model.mesh_error->compliance, "1");
  }
  file.close();
}

ReducedModel read_model(const std::filesystem::path& path) {
  const Hdf5File file = Hdf5File::open(path);
  file.require_schema(model_schema, model_schema_version);
  ReducedModel model;
  model.sector_count = file.integer_attribute("/", "sector_count");
  model.speed_max = file.number_attribute("/", "speed_max");
  if (file.has_attribute("/", "modes_at_speed")) model.modes_at_speed = file.integer_attribute("/", "modes_at_speed");
  read_stiffness_under_spin(file, model);
  if (file.has_attribute("/", "mesh_digest")) model.mesh_digest = file.text_attribute("/", "mesh_digest");
  if (file.has_text("/provenance")) model.provenance = file.read_text("/provenance");
  if (model.sector_count < 1) file.refuse("sector_count must be at least 1");
  model.contact = read_contact_line(file);
  for (int n = 0; n <= model.nodal_diameter_max(); ++n)
    model.nodal_diameters.push_back(read_nodal_diameter(file, group_of(n)));
  model.verification = read_verification(file, model.nodal_diameter_max());
  model.mesh_error = read_mesh_error(file);
  check(model, path.string());
  model.effects = file.exists("/effects") ? read_effects(file) : effects_of(model);
  require_whole(file, model);
  return model;
}

}  // namespace tiprub
