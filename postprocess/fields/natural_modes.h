// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "postprocess/fields/field_recovery.h"
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

}  // namespace tiprub::postprocess
