// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cases/program/progress.h"
#include "postprocess/analysis/study.h"
#include "postprocess/fields/field_peak.h"
#include "postprocess/fields/field_recovery.h"
#include "postprocess/fields/natural_modes.h"
#include "postprocess/fields/wheel_motion.h"

namespace tiprub {

/// The wheel's motion at a critical speed, on the sector's nodes.
struct MovingWheel {
  double speed = 0;              ///< [rad/s]
  WheelMotion motion;            ///< its waves, without their states
  std::vector<WaveField> waves;  ///< the same on the nodes
  double displacement = 0;       ///< [m] the farthest that any node moves
  Eigen::VectorXd vibration;     ///< [Pa] the largest von Mises stress over the cycle and the sectors; by node
  Eigen::VectorXd spin;          ///< [Pa] of the static shape under spin alone
  Eigen::VectorXd both;          ///< [Pa] the largest of their sum
};

/// Full fields of a study.
struct FieldStudy {
  SectorFields sector;
  double speed = 0;                 ///< [rad/s] of the modes and the contact instant: the worst critical speed
  NaturalModes modes;               ///< at that speed
  bool has_instant = false;         ///< whether the response holds the rotor's state; if not, the rest is empty
  double angle = 0;                 ///< [rad] of the rotor at the contact instant, from the start of the recording
  double force = 0;                 ///< [N] all contact forces then
  WheelField vibration, spin;       ///< at the contact instant
  StressZones zones;                ///< where stress is read
  std::vector<FieldPeak> peaks;     ///< at every critical speed, and at the speed of the instant
  std::vector<MovingWheel> moving;  ///< at every critical speed that has a cycle
};

/// Recovers everything. Raises InputError if the fields are of another model.
FieldStudy recover_fields(const std::filesystem::path& fields_file, const Study& study,
                          const std::optional<MaterialStrength>& strength, Progress::Shown shown);

/// Only looks whether the fields are those of the model; raises as recover_fields() does.
void check_fields(const std::filesystem::path& fields_file, const ReducedModel& model);

/// At the speed of the contact instant; null if it has no cycle.
const MovingWheel* moving_at_instant(const FieldStudy& fields);

/// modes_sector.vtu, modes_wheel.vtu, contact_sector.vtu, contact_wheel.vtu; motion_sector.pvd and its frames in
/// motion_sector/, if there is a motion.
void write_vtu_files(const FieldStudy& fields, const std::filesystem::path& folder);

}  // namespace tiprub
