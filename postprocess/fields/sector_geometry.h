// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <map>
#include <string>
#include <vector>

#include "mesh/cells/free_faces.h"
#include "reduce/model/fields_file.h"

namespace tiprub::postprocess {

/// [m] r and z of a place in x, y, z.
Eigen::Vector2d meridional(const Eigen::Vector3d& place);

/// The name of the part that carries the blades.
inline constexpr const char* disc_part = "disc";

/// A part's name for people: "main blade" for "main_blade".
std::string spoken(std::string part);

/// The tip line's nodes from the leading to the trailing edge, or the contact nodes if the fields do not list them.
const std::vector<int>& tip_line(const SectorFields& sector);

/// Describes in words where a node of a sector is: "main blade at mid-span, at 40 % of its length".
///
/// Span and length are measured in the meridional plane (r, z). Straight lines begin at points of the root, where
/// the blade with the tip line meets the `disc`, and end at the points of the tip line at the same share of its
/// length. A splitter is measured by the same lines, between its own leading and trailing edges. Without the parts
/// `disc` and a blade, only the part's name is given, if there is one.
class BladePlaces {
 public:
  explicit BladePlaces(const SectorFields& sector);

  /// The part to which most cells at a node belong; empty without parts.
  std::string part(int node) const;
  std::string words(int node) const;

 private:
  struct Share {
    double span, length;  ///< [1] of the way from root to tip line, and from leading to trailing edge
  };
  Share share(int node) const;
  int bricks_of(const std::string& part, int node) const;
  void lay_lines(const std::string& blade);

  const SectorFields& sector_;
  std::map<std::string, std::vector<int>> bricks_;  ///< by part and node
  Eigen::Matrix2Xd root_, tip_;                     ///< [m] ends of the lines, leading to trailing edge
  std::map<std::string, std::pair<double, double>>
      length_ends_;  ///< [1] a blade's first and last length among the lines
};

/// A face on the surface, and on which side of the sector it lies.
struct SurfaceFace : FreeFace {
  enum class Side { free, cyclic_low, cyclic_high };

  Side side = Side::free;

  int corners() const { return static_cast<int>(FreeFace::corners()); }
};

/// The surface of a sector; the faces on the cut planes are marked.
std::vector<SurfaceFace> sector_surface(const SectorFields& sector);
/// The surface of some of its cells.
std::vector<SurfaceFace> sector_surface(const SectorFields& sector, const Eigen::MatrixXi& cells);

}  // namespace tiprub::postprocess
