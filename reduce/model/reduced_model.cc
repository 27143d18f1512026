// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/reduced_model.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "cases/program/digest.h"
#include "cases/program/errors.h"
#include "cases/program/text.h"
#include "cases/program/units.h"
#include "reduce/model/dense_eigen.h"
#include "reduce/model/nodal_diameter.h"

namespace tiprub {

namespace {

constexpr double hermitian_tolerance = 1e-9;  // of the largest entry
constexpr double unit_tolerance = 1e-6;
constexpr double arc_tolerance = 1e-3;                // of a step along the contact line
constexpr double half_circle = std::numbers::pi / 2;  // arc over chord: no tip bends more between two nodes
constexpr double full_turn = 2 * std::numbers::pi;
constexpr double most_inward = -0.1;        // mean radial component of the normals
constexpr double least_distance = 1e-9;     // of the radius, between two contact nodes
constexpr double largest_shift = 0.02;      // of the radius
constexpr double tolerable_misfit = 0.001;  // error of a frequency caused by eq. 7
constexpr double tolerable_error = 0.001;   // of a frequency, at the verification speeds

/// The parts of the message stand one after another.
template <class... Parts>
void require(bool holds, const Parts&... message) {
  if (!holds) throw FileError(text_of(message...));
}

template <class Matrix>
std::string shape(const Matrix& matrix) {
  return std::to_string(matrix.rows()) + " x " + std::to_string(matrix.cols());
}

void check_hermitian(const Eigen::MatrixXcd& matrix, const std::string& where) {
  const double scale = matrix.cwiseAbs().maxCoeff();
  const double skew = (matrix - matrix.adjoint()).cwiseAbs().maxCoeff();
  require(skew <= hermitian_tolerance * scale, where,
          " is not Hermitian: it differs from its conjugate transpose by ", std::to_string(skew / scale),
          " of its largest entry");
}

void check(const NodalDiameterModel& model, int contact_dofs, bool real, const std::string& where) {
  const Eigen::Index size = model.M.rows();
  require(size > 0 && size >= contact_dofs, where, "/M is ", shape(model.M), ", but the contact nodes alone have ",
          contact_dofs, " dofs");
  require(!model.K.terms.empty(), where, " has no K0");
  std::vector<std::pair<std::string, const Eigen::MatrixXcd&>> all = {{"/M", model.M}};
  for (std::size_t k = 0; k < model.K.terms.size(); ++k) all.emplace_back("/K" + std::to_string(k), model.K.terms[k]);
  for (const auto& [name, matrix] : all) {
    require(matrix.rows() == size && matrix.cols() == size, where, name, " is ", shape(matrix), ", must be ", size,
            " x ", size);
    check_hermitian(matrix, where + name);
    require(!real || matrix.imag().cwiseAbs().maxCoeff() <= hermitian_tolerance * matrix.cwiseAbs().maxCoeff(), where,
            name, " must be real: this nodal diameter is a standing wave");
  }
  for (int dof = 0; dof < contact_dofs; ++dof)
    require(model.M(dof, dof).real() > 0, where, "/M has no mass in contact dof ", dof);
  require(Eigen::LLT<Eigen::MatrixXcd>(model.M).info() == Eigen::Success, where, "/M is not positive definite");
}

/// In the meridional plane (r, z) the arc from one contact node to the next must not be shorter than the straight
/// line between them, nor much longer.
void check_step(const ContactLine& contact, Eigen::Index k, const std::string& name) {
  const double along = contact.arc_length[k] - contact.arc_length[k - 1];
  require(along > 0, name, ": /contact/arc_length must increase from the leading edge");
  // A splitter has the arc lengths of the main blade's line beside it, which differ from its own where the lines
  // bend.
  const double tolerance = k > contact.trailing_edge() ? half_circle - 1 : arc_tolerance;
  const Eigen::RowVector3d step = contact.position.row(k) - contact.position.row(k - 1);
  const double across = std::hypot(step[0], step[2]);
  require(across <= along * (1 + tolerance) && along <= half_circle * across, name, ": /contact/arc_length grows by ",
          along, " m from node ", k - 1, " to node ", k, ", but /contact/position has them ", across,
          " m apart in the meridional plane; both must be in metres, from leading to trailing edge");
}

/// From blade to casing normals point away from the axis, or along it where the casing turns to the side.
void check_normals(const ContactLine& contact, const std::string& name) {
  for (Eigen::Index k = 0; k < contact.normal.rows(); ++k)
    require(std::abs(contact.normal.row(k).norm() - 1) < unit_tolerance, name, ": /contact/normal: row ", k,
            " is not of unit length");
  const double outward = contact.normal.col(0).mean();
  require(outward > most_inward, name, ": /contact/normal has the mean radial component ", outward,
          ", must be above ", most_inward, ": normals point from the blade to the casing; reverse them");
}

/// Angles in degrees are told by their size.
void check_place(const ContactLine& contact, Eigen::Index k, const std::string& name) {
  const double radius = contact.position(k, 0), theta = contact.position(k, 1);
  require(radius > 0 && std::abs(theta) <= full_turn, name, ": /contact/position: row ", k, " has r = ", radius,
          " m and theta = ", theta, " rad; r must be above 0, and theta within a turn: is it in degrees?");
}

/// A splitter has the main blade's arc lengths, so that these do not tell its nodes from the main blade's.
void check_apart(const ContactLine& contact, Eigen::Index k, const std::string& name) {
  for (Eigen::Index other = 0; other < k; ++other) {
    const Eigen::RowVector3d step = contact.position.row(k) - contact.position.row(other);
    const double around = contact.position(k, 0) * std::remainder(step[1], full_turn);
    require(std::hypot(step[0], around, step[2]) > least_distance * contact.position(k, 0), name,
            ": /contact/position: rows ", other, " and ", k, " are the same place; each contact node is listed once");
  }
}

void check(const SecondOrderGap& gap, Eigen::Index count, const std::string& where) {
  const Eigen::Index p = gap.coordinates.cols();
  require(gap.curvature.rows() == count, where, "/curvature is ", shape(gap.curvature), ", must be ", count, " x 2");
  require(gap.coordinates.rows() == 3 * count && p > 0, where, "/V is ", shape(gap.coordinates), ", must have ",
          3 * count, " rows, one for each contact dof, and a column or more");
  require(static_cast<Eigen::Index>(gap.displacement.size()) == count, where, "/Q holds ", gap.displacement.size(),
          " matrices, must hold ", count);
  for (const Eigen::MatrixXd& Q : gap.displacement) {
    require(Q.rows() == p && Q.cols() == p, where, "/Q has matrices of ", shape(Q), ", must be ", p, " x ", p,
            ", as /V has columns");
    require((Q - Q.transpose()).cwiseAbs().maxCoeff() <= hermitian_tolerance * Q.cwiseAbs().maxCoeff(), where,
            "/Q has a matrix that is not symmetric");
  }
}

void check(const ContactLine& contact, const std::string& name) {
  const Eigen::Index count = contact.arc_length.size();
  require(count > 0, name, ": /contact holds no node");
  require(contact.splitter_nodes >= 0 && contact.splitter_nodes < count, name,
          ": /contact/blade must begin with 0, the main blade, and may go on with 1, the splitter");
  require(!contact.static_shift.terms.empty(), name, ": /contact has no static shift");
  std::vector<const Eigen::MatrixX3d*> tables = {&contact.position, &contact.normal};
  for (const Eigen::MatrixX3d& shift : contact.static_shift.terms) tables.push_back(&shift);
  for (const auto* table : tables)
    require(table->rows() == count, name, ": /contact: every table must have ", count, " rows");
  check_normals(contact, name);
  for (Eigen::Index k = 0; k < count; ++k) {
    check_place(contact, k, name);
    if (k > 0 && k != contact.trailing_edge() + 1) check_step(contact, k, name);
    check_apart(contact, k, name);
  }
  if (contact.second_order) check(*contact.second_order, count, name + ": /contact/second_order");
}

/// Frequencies of a rotor that is stable at the verified speeds; what is at most 0 has no relative error.
void check_frequencies(const Eigen::MatrixXd& frequencies, const std::string& where) {
  require(frequencies.minCoeff() > 0, where, " holds ", frequencies.minCoeff(),
          " Hz, must be above 0: the rotor must be held, and stable at the verified speeds");
}

void check(const Verification& table, std::size_t nodal_diameters, const std::string& name) {
  const Eigen::MatrixXd& misfit = table.polynomial_misfit;
  require(table.speeds.size() == 0 || (table.speeds[0] >= 0 && std::ranges::is_sorted(table.speeds)), name,
          ": /verification/speed must begin at 0 or above, and ascend");
  require(misfit.size() == 0 ||
              (misfit.rows() == table.speeds.size() && misfit.cols() == static_cast<Eigen::Index>(nodal_diameters)),
          name, ": /verification/polynomial_misfit is ", shape(misfit), ", must be ", table.speeds.size(), " x ",
          nodal_diameters);
  if (const auto& shape = table.shape_balance)
    require(shape->imbalance >= 0 && shape->tolerance >= 0, name,
            ": /verification: shape_imbalance and shape_tolerance must be at least 0");
  for (const auto& [kind, tables] :
       {std::pair("unreduced", &table.unreduced), std::pair("reduced", &table.reduced)}) {
    if (table.speeds.size() == 0 && tables->empty()) continue;
    require(tables->size() == nodal_diameters, name, ": /verification must have every nodal diameter");
    for (std::size_t n = 0; n < nodal_diameters; ++n) {
      const Eigen::MatrixXd &found = (*tables)[n], &other = table.unreduced[n];
      const std::string where = name + ": /verification/nodal_diameter/" + std::to_string(n) + "/" + kind;
      require(found.rows() == table.speeds.size() && found.cols() == other.cols() && found.cols() > 0, where, " is ",
              shape(found), ", must be ", table.speeds.size(), " x ",
              other.cols() > 0 ? std::to_string(other.cols()) : "at least 1");
      check_frequencies(found, where);
    }
  }
}

void check(const MeshError& error, Eigen::Index nodal_diameters, Eigen::Index contacts, const std::string& where) {
  require(error.frequency.rows() == nodal_diameters && error.frequency.cols() > 0, where, "/frequency is ",
          shape(error.frequency), ", must be ", nodal_diameters, " x at least 1");
  require(error.compliance.size() == contacts, where, "/compliance holds ", error.compliance.size(),
          " values, must hold ", contacts, ", one for each contact unknown");
  require(error.frequency.minCoeff() >= 0 && error.compliance.minCoeff() >= 0, where,
          " holds an error below 0; a mesh makes a sector stiffer");
}

/// Eq. 7 is exact for linear prestress, and nonlinear prestress is exact but for eq. 7.
ModelledEffect spin_stiffness(const ReducedModel& model) {
  const bool whole = model.prestress == Prestress::nonlinear && model.spin_softening == SpinSoftening::on;
  ModelledEffect effect{Effect::spin_stiffness, whole ? Treatment::modelled : Treatment::simplified,
                        model.stiffness_under_spin() + " prestress"};
  if (model.prestress == Prestress::nonlinear) effect.size = polynomial_misfit(model);
  return effect;
}

struct Compared {
  double unreduced = 0;  ///< [Hz]
  double error = 0;      ///< [1]
};

/// The wheel's frequencies at one verified speed, as far as all nodal diameters reach; ascending.
std::vector<Compared> compared_frequencies(const ReducedModel& model, Eigen::Index speed) {
  const Verification& verified = model.verification;
  double end = std::numeric_limits<double>::infinity();
  for (const Eigen::MatrixXd& table : verified.unreduced) end = std::min(end, table.row(speed).maxCoeff());
  std::vector<Compared> wheel;
  for (std::size_t n = 0; n < verified.unreduced.size(); ++n) {
    const int count = wave_count(static_cast<int>(n), model.sector_count);
    for (Eigen::Index mode = 0; mode < verified.unreduced[n].cols(); ++mode) {
      const double exact = verified.unreduced[n](speed, mode);
      if (exact <= end && exact != 0)  // a rigid motion has no relative error
        wheel.insert(wheel.end(), count, {exact, std::abs(verified.reduced[n](speed, mode) / exact - 1)});
    }
  }
  std::ranges::sort(wheel, {}, &Compared::unreduced);
  return wheel;
}

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

std::vector<ModelledEffect> effects_of(const ReducedModel& model) {
  Eigen::Index dofs = 0;
  for (const NodalDiameterModel& matrices : model.nodal_diameters) dofs = std::max(dofs, matrices.M.rows());
  return {{Effect::blade_mistuning, Treatment::left_out, "all sectors have the same matrices"},
          spin_stiffness(model),
          {Effect::coriolis, Treatment::left_out, "the matrices hold no gyroscopic terms"},
          {Effect::reduced_modes, Treatment::simplified,
           text_of("at most ", dofs, " degrees of freedom a nodal diameter")},
          {Effect::contact_resolution, Treatment::simplified,
           text_of(model.contact.size(), " ", name_of(model.contact.kind), "s")},
          {Effect::mesh, Treatment::simplified, "finite elements"}};
}

std::string ReducedModel::stiffness_under_spin() const {
  return std::string(name_in(prestress_names, prestress)) +
         (spin_softening == SpinSoftening::off ? without_spin_softening : "");
}

const char* name_of(ContactKind kind) {
  return kind == ContactKind::points ? "contact node" : "contact segment";
}

Eigen::VectorXd NodalDiameterModel::natural_frequencies(double speed) const {
  return eigenvalues(stiffness(speed), M).unaryExpr([](double square) {
    return std::copysign(std::sqrt(std::abs(square)), square) / (2 * std::numbers::pi);
  });
}

std::string ContactLine::place_of(int node) const {
  if (node == 0) return "leading edge";
  if (node <= trailing_edge()) return node == trailing_edge() ? "trailing edge" : "";
  if (node == trailing_edge() + 1) return "splitter's leading edge";
  return node == size() - 1 ? "splitter's trailing edge" : "splitter";
}

void check(const ReducedModel& model, const std::string& name) {
  require(model.sector_count > 0, name, ": sector_count must be at least 1");
  require(model.speed_max >= 0, name, ": speed_max must be at least 0");
  check(model.contact, name);
  const int expected = model.nodal_diameter_max() + 1;
  require(static_cast<int>(model.nodal_diameters.size()) == expected, name, ": has ", model.nodal_diameters.size(),
          " nodal diameters, must have ", expected, " for ", model.sector_count, " sectors");
  for (int n = 0; n < expected; ++n)
    check(model.nodal_diameters[n], model.contact_dofs(), is_standing(n, model.sector_count),
          name + ": /nodal_diameter/" + std::to_string(n));
  check(model.verification, model.nodal_diameters.size(), name);
  if (model.mesh_error) check(*model.mesh_error, expected, model.contact.size(), name + ": /mesh_error");
}

std::optional<double> polynomial_misfit(const ReducedModel& model) {
  const Verification& verified = model.verification;
  std::optional<double> largest;
  for (Eigen::Index row = 0; row < verified.polynomial_misfit.rows(); ++row)
    if (verified.speeds[row] <= model.speed_max)
      largest = std::max(largest.value_or(0), verified.polynomial_misfit.row(row).maxCoeff());
  return largest;
}

ModelError model_error(const ReducedModel& model, int most) {
  ModelError found;
  const Eigen::VectorXd& speeds = model.verification.speeds;
  if (speeds.size() == 0 || model.verification.unreduced.empty()) return found;
  std::vector<std::vector<Compared>> wheels;
  std::size_t count = static_cast<std::size_t>(std::max(most, 0));
  for (Eigen::Index speed = 0; speed < speeds.size(); ++speed) {
    wheels.push_back(compared_frequencies(model, speed));
    count = std::min(count, wheels.back().size());
  }
  found.frequencies = static_cast<int>(count);
  for (std::size_t speed = 0; speed < wheels.size(); ++speed)
    for (std::size_t i = 0; i < count; ++i) {
      if (wheels[speed][i].error <= found.error) continue;
      found.error = wheels[speed][i].error;
      found.speed = speeds[static_cast<Eigen::Index>(speed)];
    }
  return found;
}

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
            "is exact; ";
  return text.str();
}

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
  if (contact.second_order) {
    add(digest, Eigen::MatrixXd(contact.second_order->curvature));
    add(digest, contact.second_order->coordinates);
    for (const Eigen::MatrixXd& Q : contact.second_order->displacement) add(digest, Q);
  }
  for (const NodalDiameterModel& matrices : model.nodal_diameters) {
    for (int k = 0; k <= 2; ++k) add(digest, matrices.K.coefficient(k));
    add(digest, matrices.M);
    for (int k = 3; k <= matrices.K.highest(); ++k) add(digest, matrices.K[k]);
  }
  add(digest, Eigen::MatrixXd(model.verification.speeds));
  add(digest, model.verification.polynomial_misfit);
  if (const auto& shape = model.verification.shape_balance) {
    digest.add(shape->imbalance);
    digest.add(shape->tolerance);
  }
  for (const auto* frequencies : {&model.verification.unreduced, &model.verification.reduced})
    for (const Eigen::MatrixXd& table : *frequencies) add(digest, table);
  return digest.digits();
}

}  // namespace tiprub
