// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <map>
#include <string>
#include <vector>

#include "reduce/model/fields_file.h"

namespace tiprub {

/// [m] r and z of a place in x, y, z.
Eigen::Vector2d meridional(const Eigen::Vector3d& place);

/// The part that blades stand on.
inline constexpr const char* disc_part = "disc";

/// A part's name for people: "main blade" for "main_blade".
std::string spoken(std::string part);

/// The tip line's nodes, leading to trailing edge: all of them where the fields know them, else the contact nodes.
const std::vector<int>& tip_line(const SectorFields& sector);

/// Words for where a node of a sector is: "main blade at mid-span, at 40 % of its length".
///
/// A blade's span and length are those of the meridional plane (r, z): straight lines lead from points of the root
/// of the blade with the tip line (where blade and `disc` meet) to points of the tip line at the same share of its
/// length. A splitter is measured by the same lines, from its own leading edge to its own trailing edge. Needs the
/// parts `disc` and a blade; without them there are only the part's name, or no words.
class BladePlaces {
 public:
  explicit BladePlaces(const SectorFields& sector);

  /// The part that most of a node's bricks belong to; empty without parts.
  std::string part(int node) const;
  std::string words(int node) const;

 private:
  struct Share {
    double span, length;  ///< [1] of the root's to the tip line's distance; of the way from the leading edge
  };
  Share share(int node) const;
  int bricks_of(const std::string& part, int node) const;
  void lay_lines(const std::string& blade);

  const SectorFields& sector_;
  std::map<std::string, std::vector<int>> bricks_;                ///< by part and node
  Eigen::Matrix2Xd root_, tip_;                                   ///< [m] ends of the lines, leading to trailing edge
  std::map<std::string, std::pair<double, double>> length_ends_;  ///< [1] of a blade, by the lines' count
};

}  // namespace tiprub
