// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <optional>

#include "postprocess/analysis/critical_speeds.h"
#include "reduce/model/fields_file.h"
#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub::postprocess {

/// The depth to which contact would wear the casing, as an order of magnitude.
struct CasingWear {
  int node = 0;      ///< contact node whose track is worn most
  double force = 0;  ///< [N] of that node, mean over time and blades
  double depth = 0;  ///< [m] mean over the places of that track that are rubbed
};

/// Archard (1953): the worn volume is (k/H) F s, with k/H the `coefficient` [m^2/N], F the normal force and s the
/// sliding distance. At a contact node all N blades rub the same track of the casing. Its width w reaches half way to
/// the neighbouring nodes, and a share phi of its circumference is rubbed. In the time t [s] each blade slides r
/// Omega t, so that the depth does not depend on the radius r:
///
///     (k/H) N F Omega t/(2 pi phi w).
///
/// The forces are those of a casing that does not wear.
CasingWear casing_wear(const SpeedResponse& response, const SimulatedScene& scene, const ContactLine& contact,
                       double coefficient, double time);

/// How far the tip moves along the casing for each length along its normal.
struct SlidingShare {
  int node = 0;      ///< contact node with the largest mean force
  double ratio = 0;  ///< [1] u_theta over nu . u, by least squares over all sectors and samples
};

/// A drag of mu times the contact force, against the rotation, does mu times this ratio of the force's work on the
/// vibration. Nothing if there is no contact or no motion along the normal.
std::optional<SlidingShare> sliding_share(const SpeedResponse& response, const SimulatedScene& scene,
                                          const ContactLine& contact);

/// [m] The distance from each contact node to the nearest node of the part `disc`; empty without that part.
Eigen::VectorXd tip_spans(const SectorFields& sector);

/// [rad/s] Frequencies with the Coriolis terms, ascending; negative ones belong to waves in the opposite
/// direction. `modes` are the frequencies [rad/s] without them, above zero; `coupling` is the skew-Hermitian
/// integral G of rho conj(u_i) . (e_z x u_j) for modes of unit modal mass. The equation (-omega^2 + 2 i Omega
/// omega G + diag(modes^2)) q = 0 becomes, with H = i G and W = diag(modes), the Hermitian eigenproblem of [0 W; W
/// 2 Omega H].
Eigen::VectorXd gyroscopic_frequencies(const Eigen::VectorXd& modes, const Eigen::MatrixXcd& coupling, double speed);

/// [m^3] The weight of each sector node in integrals over the volume, exact for quadratic integrands in
/// parallelepipeds. Corners of 20-node bricks and of 10-node tetrahedra have negative weights.
Eigen::VectorXd node_volumes(const SectorFields& sector);

/// The coupling of shapes of unit modal mass (3 nodes x shapes; r, theta, z of node 0, then of node 1, ...) with
/// the nodes' masses [kg]. The shapes are not scaled to unit mass here: because some masses are negative, the mass
/// of a shape that varies within a cell could vanish.
Eigen::MatrixXcd coriolis_coupling(const Eigen::MatrixXcd& shapes, const Eigen::VectorXd& masses);

/// How much the Coriolis terms, which the model leaves out, change the frequency of the mode that makes a critical
/// speed: M q'' + 2 Omega G q' + K q = 0 is solved in the lowest modes of its nodal diameter, with u* G u the
/// integral of rho conj(u) . (e_z x u) over shapes that are recovered on the sector.
struct CoriolisShift {
  double change = 0;  ///< [1] relative, the larger one for the two directions of the wave
  double speed = 0;   ///< [rad/s] the critical one
  int nodal_diameter = 0;
  int family = 0;  ///< from 0
};

/// What the full fields show about the effects that are left out.
struct FieldEffects {
  Eigen::VectorXd tip_span{};               ///< [m] see tip_spans(); may be empty
  std::optional<CoriolisShift> coriolis{};  ///< the largest of all critical speeds; nothing if there are none
};

/// [1] By how much the mesh makes the critical speed of a wave's mode too high. Spin adds B Omega^2 to the square of
/// the frequency f_0 at rest, f^2 = f_0^2 + B Omega^2, so that the speed at which f is the engine order times Omega
/// is proportional to f_0, and its relative error is that of f_0. Nothing if the model has no estimate for this mode.
std::optional<double> mesh_shift(const ReducedModel& model, const WaveLabel& wave);

/// Of fields that passed check_fields().
FieldEffects field_effects(const FieldsReader& fields, const ReducedModel& model,
                           const std::vector<CriticalSpeed>& critical);

}  // namespace tiprub::postprocess
