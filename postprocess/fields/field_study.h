// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cases/program/progress.h"
#include "postprocess/analysis/study.h"
#include "postprocess/fields/field_peak.h"
#include "postprocess/fields/field_recovery.h"
#include "postprocess/fields/stress_over_speed.h"
#include "postprocess/fields/wheel_cycle.h"
#include "reduce/model/reduced_model.h"

namespace tiprub::postprocess {

/// A natural mode on the sector's nodes, its largest component 1.
struct ModeField {
  int family = 0;        ///< from 0
  double frequency = 0;  ///< [Hz]
  WaveField wave;
};

/// The share of each part of the wheel in a natural mode.
struct ModeShares {
  int nodal_diameter = 0, family = 0;   ///< family from 0
  double frequency = 0;                 ///< [Hz]
  std::map<std::string, double> share;  ///< [1] by part: see part_shares()
};

/// Natural modes of the wheel at one speed, for the nodal diameters that the casing's lowest harmonics excite.
struct NaturalModes {
  /// The lowest families, by nodal diameter and then family, followed by the modes of the disc (disc_modes()).
  std::vector<ModeField> drawn;
  std::vector<ModeShares> shares;  ///< of all examined families, by nodal diameter, then family
};

/// At a speed [rad/s]; at most `families` of the lowest families are drawn. If the mesh does not name its parts,
/// there are no shares and no modes of the disc.
NaturalModes natural_modes(const FieldsReader& reader, const ReducedModel& model, int lobes, int families,
                           double speed);

/// [1] Each part's share of the integral of |u|^2 over the wheel, with the mean over a cell's nodes in each cell.
/// `volumes` [m^3] by cell; `displacement` 3 x nodes.
std::map<std::string, double> part_shares(const SectorFields& sector, const Eigen::VectorXd& volumes,
                                          const Eigen::Matrix3Xcd& displacement);

/// Chooses, among the families from `first` on, the one in which the disc has the largest share, judged by the two
/// modes with the largest shares. Returns the places of these two in `shares`, ascending; empty if all shares are
/// 0.
std::vector<std::size_t> disc_modes(const std::vector<ModeShares>& shares, int first);

/// The wheel's motion at a critical speed, on the sector's nodes.
struct MovingWheel {
  double speed = 0;              ///< [rad/s]
  WheelMotion motion;            ///< its waves, without their states
  std::vector<WaveField> waves;  ///< the same on the nodes
  CycleStress stress;            ///< over that cycle
};

/// Full fields of a study.
struct FieldStudy {
  SectorFields sector;
  double speed = 0;    ///< [rad/s] the critical speed of the largest amplitude, of the modes and the contact instant
  NaturalModes modes;  ///< at that speed
  bool has_instant = false;      ///< whether the response holds the rotor's state; if not, what follows is empty
  double angle = 0;              ///< [rad] of the rotor at the contact instant, from the start of the recording
  double force = 0;              ///< [N] all contact forces then
  WheelField vibration, spin;    ///< at the contact instant
  StressZones zones;             ///< where stress is read
  std::vector<FieldPeak> peaks;  ///< at every critical speed, and at the speed of the instant
  /// [Pa] By `peaks`: the stress of the vibration at each varied peak in SpeedResponse::budget that has a cycle, as
  /// FieldPeak::body has it; of the nodes that are much stressed at one of `peaks`, and of those of another model's
  /// mesh near the most stressed ones.
  std::vector<std::vector<std::optional<double>>> varied;
  std::vector<MovingWheel> moving;  ///< at every critical speed that has a cycle
  EstimatedStress estimated;        ///< at every speed of the response
  /// [1] what each cell contributes to the mean errors that the mesh makes; empty if they are not estimated.
  Eigen::VectorXd mesh_error_of_frequencies, mesh_error_of_compliances;
};

/// Raises InputError if the fields are of another model, or if a cell has no stress.
void check_fields(const FieldsReader& reader, const ReducedModel& model);

/// Recovers all full fields from those that check_fields() has accepted. `other`: those of the model that error
/// budgets compare with, which check_budget_fields() has accepted; may be null.
FieldStudy recover_fields(const FieldsReader& reader, const FieldsReader* other, const Study& study,
                          const std::optional<MaterialStrength>& strength, Progress::Shown shown);

/// What tables and page show of the full fields.
struct FieldResults {
  std::string scope;  ///< one line: what was recovered, or why nothing was
  /// One per critical speed; nothing without full fields, or where the response holds no state of the rotor.
  std::vector<std::optional<FieldPeak>> peaks;
  /// At the largest amplitude, if no speed is critical; otherwise nothing.
  std::optional<FieldPeak> of_no_critical = {};
  /// One list per critical speed, as FieldStudy has them; may be empty.
  std::vector<std::vector<std::optional<double>>> varied = {};
  double zone_width = 0;             ///< [m] see StressZones
  Eigen::VectorXd over_speed = {};   ///< [Pa] EstimatedStress::vibration; empty without full fields
  Eigen::VectorXd utilisation = {};  ///< [1] EstimatedStress::utilisation

  bool has_stress() const;
  /// Whether a critical speed's stress is that of a whole cycle.
  bool has_cycles() const;
  /// The cycle with the largest utilisation; nullptr if the case gives no strengths, or no cycle was recovered.
  const StressCycle* worst_cycle() const;
};

/// Without `fields`, all peaks are empty.
FieldResults field_results(const std::optional<FieldStudy>& fields, const std::vector<CriticalSpeed>& critical);

/// [1] Goodman's utilisation at every speed of the response: that of the cycle where one was recovered, elsewhere the
/// estimate FieldResults::utilisation; empty without that.
Eigen::VectorXd utilisation_over_speed(const Study& study, const FieldResults& fields);

/// The critical speed with the largest utilisation; of those of equal or no utilisation, that with the largest stress
/// of the vibration; without any stress, that with the largest amplitude. Nothing if no speed is critical.
std::optional<std::size_t> worst_critical(const Study& study, const FieldResults& fields);

}  // namespace tiprub::postprocess
