// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

#include "cases/program/named_values.h"
#include "reduce/model/modelled_effects.h"
#include "reduce/model/speed_polynomial.h"

namespace tiprub {

/// The reduced matrices of one nodal diameter n (eq. 10): a travelling wave u_j = Re(u e^{i n j alpha}) over the
/// sectors j, alpha = 2 pi / N (the paper's eq. 6 in half the size). Rows: r, theta, z of each contact node from
/// leading to trailing edge, then the generalized dofs. All n x n and Hermitian; real for n = 0 and n = N/2.
struct NodalDiameterModel {
  /// [N/m in contact rows] stiffness, K0 + Omega^2 K1 + Omega^4 K2 (eq. 7), and with more terms on to Omega^6, ...
  SpeedPolynomial<Eigen::MatrixXcd, 0> K;
  Eigen::MatrixXcd M;  ///< [kg in contact rows] mass, positive definite

  /// eq. 11, one block; at a speed in rad/s.
  Eigen::MatrixXcd stiffness(double speed) const { return K(speed); }
  /// [Hz], ascending, at a speed in rad/s. A negative eigenvalue (an unstable rotor) gives a negative frequency.
  Eigen::VectorXd natural_frequencies(double speed) const;
};

/// How the loaded shape changes the stiffness.
enum class Prestress {
  given,        ///< as it is in the matrices that came with the sector, or with a model made by hand
  stress_only,  ///< K0 + Omega^2 (K_sigma - M_perp): the stress of the linear static solution, on the shape at rest
  linear,       ///< material stiffness at F = I + grad u of the linear static solution, plus its K_sigma: what
                ///< CalculiX does after a linear static step; then quadratic in Omega^2, exactly as eq. 7
  nonlinear,    ///< the consistent tangent (St Venant-Kirchhoff, total Lagrangian) at the converged shape under spin:
                ///< what CalculiX does after a static step with NLGEOM; eq. 7 is then an approximation
};

inline constexpr NamedValues<Prestress, 4> prestress_names = {{{Prestress::given, "given"},
                                                               {Prestress::stress_only, "stress_only"},
                                                               {Prestress::linear, "linear"},
                                                               {Prestress::nonlinear, "nonlinear"}}};

/// Whether K(Omega) holds -Omega^2 M_perp. Physics says yes; without it is for study.
enum class SpinSoftening { on, off };
inline constexpr NamedValues<SpinSoftening, 2> softening_names = {
    {{SpinSoftening::on, "on"}, {SpinSoftening::off, "off"}}};

/// The kind of the contact unknowns.
enum class ContactKind {
  points,    ///< the displacement of a node: forces act at points
  segments,  ///< a weighted mean over a stretch of the tip: forces are spread over it with the same weights
};

inline constexpr NamedValues<ContactKind, 2> contact_kind_names = {
    {{ContactKind::points, "points"}, {ContactKind::segments, "segments"}}};

/// "contact node", "contact segment": for people.
const char* name_of(ContactKind kind);

/// How gaps change with the square of the vibration. With the motion u of a contact unknown as linear dynamics have
/// it, u_theta around and u_m along the casing, the gap is narrower by
///     n.u + (c_1 u_theta^2 + c_2 u_m^2) / 2 + y' Q y,        y = V' u of all unknowns of a sector.
/// c is the curvature of the casing. y' Q y is the displacement along the normal n that follows from the bending of
/// the blade, negative where it shortens the blade.
struct SecondOrderGap {
  Eigen::MatrixX2d curvature;   ///< [1/m] around and along the casing, positive where it bends round the blade
  Eigen::MatrixXd coordinates;  ///< [1] V, of the motion of the blades; contact dofs x p
  std::vector<Eigen::MatrixXd> displacement;  ///< [1/m] Q of each contact unknown, symmetric; n_c of p x p
};

/// The tip line of the main blade of sector 0, from leading to trailing edge, and maybe that of its splitter after
/// it; n_c nodes, or the centres of n_c segments.
struct ContactLine {
  ContactKind kind = ContactKind::points;
  int splitter_nodes = 0;      ///< of the n_c; these stand on the splitter, the others on the main blade
  Eigen::MatrixX3d position;   ///< [m, rad, m] r, theta, z; n_c x 3
  Eigen::MatrixX3d normal;     ///< unit, from the blade to the casing, components r, theta, z; n_c x 3
  Eigen::VectorXd arc_length;  ///< [m] in the meridional plane, from the main blade's leading edge; n_c
  SpeedPolynomial<Eigen::MatrixX3d, 1> static_shift;  ///< [m] displacement under spin, r, theta, z; n_c x 3
  std::optional<SecondOrderGap> second_order;  ///< none of a sector without finite elements, or in a model by hand

  int size() const { return static_cast<int>(arc_length.size()); }
  /// The node at the main blade's trailing edge; its leading edge is node 0.
  int trailing_edge() const { return size() - splitter_nodes - 1; }
  /// "leading edge", "trailing edge", "splitter", "splitter's leading edge", ..., or empty: for people.
  std::string place_of(int node) const;
};

/// How well the shape under spin of nonlinear prestress, a polynomial in Omega^2, balances its load between the
/// speeds of its equilibria.
struct ShapeBalance {
  double imbalance = 0;  ///< [1] of the load; largest of these speeds
  double tolerance = 0;  ///< [1] what was asked for

  bool operator==(const ShapeBalance&) const = default;
};

/// Frequencies of the unreduced sector that verify the reduction, with those of the model beside them.
struct Verification {
  Eigen::VectorXd speeds;                  ///< [rad/s]; n_s
  std::vector<Eigen::MatrixXd> unreduced;  ///< [Hz] one for each nodal diameter; n_s x n_f
  std::vector<Eigen::MatrixXd> reduced;    ///< [Hz] the same from the model; n_s x n_f
  /// [1] largest relative error of the model's first n_f frequencies that is due to eq. 7 alone; n_s x nodal
  /// diameters; empty where eq. 7 is exact (linear and stress-only prestress)
  Eigen::MatrixXd polynomial_misfit;
  std::optional<ShapeBalance> shape_balance;  ///< none where the shape under spin is exact or not known
};

/// What the sector's mesh does to the model, estimated at rest without a finer mesh (see reduce/theory.md).
struct MeshError {
  Eigen::MatrixXd frequency;   ///< [1] by which each of the lowest frequencies is too high; nodal diameters x n_f
  Eigen::VectorXd compliance;  ///< [1] by which that of each contact unknown along its normal is too small; n_c
};

/// What ReducedModel::stiffness_under_spin() ends with where K(Omega) holds no spin softening.
inline constexpr const char* without_spin_softening = ", without spin softening";

/// A small model of a rotor that holds for all its speeds: what reduce hands on to the other programs. Schema
/// "tiprub-model".
struct ReducedModel {
  int sector_count = 0;    ///< N
  double speed_max = 0;    ///< [rad/s] the model holds for 0 .. speed_max
  int modes_at_speed = 0;  ///< generalized dofs that suffice at any one speed (see condensation.h); 0: all of them
  Prestress prestress = Prestress::given;  ///< how K1, K2, ... were made
  SpinSoftening spin_softening = SpinSoftening::on;
  ContactLine contact;
  std::vector<NodalDiameterModel> nodal_diameters;  ///< n = 0 .. floor(N/2): the blocks of Bdiag, eq. 12
  Verification verification;                        ///< may be empty
  std::optional<MeshError> mesh_error;              ///< none of matrices, or of cells for which there is no estimate
  std::vector<ModelledEffect> effects;              ///< what of the wheel is in the matrices
  std::string mesh_digest;                          ///< of the sector's mesh; empty for a model by hand
  std::string provenance;                           ///< the case and the chain that made it, as text

  /// floor(N/2)
  int nodal_diameter_max() const { return sector_count / 2; }
  int contact_dofs() const { return 3 * contact.size(); }
  /// "linear", "nonlinear, without spin softening", ...: for people, and as older files have both in one text.
  std::string stiffness_under_spin() const;
};

/// The effects on a wheel that the matrices of a model hold, and those that they leave out.
std::vector<ModelledEffect> effects_of(const ReducedModel& model);

/// Raises FileError (prefixed by `name`) if a shape is wrong, a matrix is not Hermitian, a mass is not positive
/// definite, a contact dof has no mass, a normal is not of unit length or points to the axis, an angle looks like
/// degrees, two contact nodes are one, or a verified frequency or the order of the verified speeds is wrong.
void check(const ReducedModel& model, const std::string& name);

/// A name for all numbers that a march reads of a model: the contact line, the matrices, the frequencies that verify
/// it; 16 hexadecimal digits (see cases/program/digest.h). What is made from a model carries it.
std::string digest(const ReducedModel& model);

/// [1] The largest error of a frequency that is due to eq. 7 alone, at the verified speeds up to speed_max: the model
/// holds no further. None where eq. 7 is exact or no such speed was verified.
std::optional<double> polynomial_misfit(const ReducedModel& model);

/// A model's frequencies against those of the unreduced sector that it came with.
struct ModelError {
  int frequencies = 0;  ///< of the wheel, from the lowest; 0: the model came without any to compare with
  double error = 0;     ///< [1] the largest relative one of them, over all verified speeds
  double speed = 0;     ///< [rad/s] where it is
};

/// The error of at most `most` of the wheel's first frequencies (the paper counts 50), of which those of nodal
/// diameters strictly between 0 and N/2 count twice. Frequencies above the lowest of the nodal diameters' last ones
/// are left out, because others may be missing there.
ModelError model_error(const ReducedModel& model, int most = 50);

/// What makes all results of a model doubtful, for the first line of every summary: "warning: ...; ", or empty. These
/// are shift_doubts(), a shape under spin that is less in balance than was asked for, and a polynomial K(Omega) that
/// misses frequencies by more than 0.1 %.
std::string doubts(const ReducedModel& model);

/// Says so if spin at a speed [rad/s] moves the tip by more than 2 % of its radius: no metal strains so much, a value
/// is in another unit. Places and shifts [m] are r, theta, z of some nodes; n x 3.
std::string shift_doubts(const Eigen::MatrixX3d& position, const Eigen::MatrixX3d& shift, double speed);

}  // namespace tiprub
