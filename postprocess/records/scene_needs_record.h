// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

#include "postprocess/analysis/critical_speeds.h"
#include "postprocess/analysis/study.h"
#include "postprocess/tables/table.h"
#include "reduce/model/fields_file.h"
#include "reduce/model/modelled_effects.h"
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

/// How much an effect matters for a scene.
enum class NeedVerdict {
  none,           ///< it is modelled
  negligible,     ///< its size is at most the tolerance
  matters,        ///< its size is above the tolerance
  undecided,      ///< it was examined without a clear answer
  not_estimated,  ///< it was not examined
};

/// One effect as model.h5 and response.h5 describe it, with the size that is estimated here.
struct SceneNeed {
  ModelledEffect effect;
  NeedVerdict verdict = NeedVerdict::not_estimated;
  std::string how = {};  ///< how the size was estimated, or how it could be measured

  double over_tolerance() const;  ///< [1] of the size; infinite if nothing is allowed
};

/// Every effect that the model or the response names, or that is estimated here, in the order of Effect. Estimates
/// that depend on the motion are those at the judged speed; sizes that tiprub-simulate measured are the largest
/// over all speeds.
std::vector<SceneNeed> scene_needs(const Study& study, const FieldEffects& fields);

/// "negligible", "matters", "undecided" or "not estimated"; empty for what is modelled.
std::string name_of(NeedVerdict verdict);

/// "left out: friction at the tips, Coriolis terms, ...": all effects of one treatment; empty if there are none.
std::string effects_in_words(const std::vector<SceneNeed>& needs, Treatment treatment);

/// The damping of the simulation: "ratio 0.01 of critical; 0.02 above 12000 Hz".
std::string damping_text(const SimulatedScene& scene);

/// "Coriolis terms: relative change of a frequency [1]".
std::string name_with_unit(Effect effect);

/// A row for each effect, what matters most first: scene_needs.csv.
Table scene_needs_record(std::vector<SceneNeed> needs);

}  // namespace tiprub::postprocess
