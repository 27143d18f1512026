// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "postprocess/fields/field_recovery.h"
#include "reduce/model/reduced_model.h"

namespace tiprub {

/// A natural mode on the sector's nodes, its largest component 1.
struct ModeField {
  int family = 0;        ///< from 0
  double frequency = 0;  ///< [Hz]
  WaveField wave;
};

/// How much each part of the wheel takes part in a natural mode.
struct ModeShares {
  int nodal_diameter = 0, family = 0;   ///< family from 0
  double frequency = 0;                 ///< [Hz]
  std::map<std::string, double> share;  ///< [1] by part: see part_shares()
};

/// Natural modes of the wheel at one speed, of the nodal diameters that the casing's lowest harmonics drive.
struct NaturalModes {
  /// Of the lowest families, by nodal diameter, then family; after them those of the disc (disc_modes()).
  std::vector<ModeField> drawn;
  std::vector<ModeShares> shares;  ///< of all families that were looked at, by nodal diameter, then family
};

/// At a speed [rad/s]; so many families at most are the lowest. Without parts that are told apart there are no shares
/// and no modes of the disc.
NaturalModes natural_modes(const FieldsReader& reader, const ReducedModel& model, int lobes, int families,
                           double speed);

/// [1] of the integral of |u|^2 over the wheel, by part: each cell by its volume and the mean over its nodes.
/// `volumes` [m^3] by cell; `displacement` 3 x nodes.
std::map<std::string, double> part_shares(const SectorFields& sector, const Eigen::VectorXd& volumes,
                                          const Eigen::Matrix3Xcd& displacement);

/// Of the families from `first` on the one whose two modes with the largest share of the disc have the most of it;
/// their places in `shares`, ascending. Empty where no share is above zero.
std::vector<std::size_t> disc_modes(const std::vector<ModeShares>& shares, int first);

}  // namespace tiprub
