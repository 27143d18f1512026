// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/program/case_file.h"
#include "mesh/cells/cell_kind.h"

namespace tiprub::mesh {

/// The place of a half element index, 0 .. 2 count, along a direction whose elements grow by a constant factor from
/// both ends to the middle, counted in half elements of equal size. `ratio` is the largest element over the smallest;
/// one or two elements are always alike. Mid-side nodes stay in the middle of their elements.
double graded(int half_index, int count, double ratio);

/// By their number of nodes.
enum class ElementKind {
  hex20 = 20,  ///< serendipity: corners and mid-side nodes
  hex27 = 27,  ///< full quadratic: also face centres and the cell's centre
};

enum class Blades {
  none,               ///< a bare disc
  main,               ///< one blade a sector
  main_and_splitter,  ///< and a shorter one between two of them
};

enum class ClampedSurface {
  bore,
  front_face,
  bore_and_front_face,
  root,  ///< the blade's, where there is no disc
};

/// How many elements the sector has in each direction.
struct ElementCounts {
  int chord;           ///< stations from leading to trailing edge (a disc: from its front to its back)
  int upstream;        ///< of these before the splitter's leading edge
  int bore;            ///< of these opposite the bore; the others stand on the back face
  int blade;           ///< through the main blade's thickness
  int splitter;        ///< through the splitter's
  int span;            ///< from hub to tip
  int fillet;          ///< of these along the fillet at the root; 0: no fillet
  int disc;            ///< from bore or back face to hub; 0: no disc, only the main blade
  int between_blades;  ///< round one passage; without blades round the sector
};

/// The numbers and names by which the mesher divides a shape into elements.
struct SectorPlan {
  ElementKind element = ElementKind::hex20;
  int sector_count = 0;  ///< N
  Blades blades = Blades::main;
  double splitter_start = 0.0;        ///< fraction of the meridional length
  double splitter_pitch = 0.5;        ///< its place between two main blades, as a fraction of their pitch
  bool contact_on_splitters = false;  ///< also there; always on the main blade
  ClampedSurface clamped = ClampedSurface::bore;
  ElementCounts elements{};
  double grading_along_chord = 1.0;  ///< the largest element over the smallest, see graded()
  double grading_along_span = 1.0;

  bool has_disc() const { return elements.disc > 0; }
  double pitch() const;  ///< 2 pi / N [rad]
  /// The fraction of the meridional length at half of an element index, 0 .. 2 elements.chord: graded, and stretched
  /// before and after the splitter's leading edge, so that this always falls between two elements.
  double station(int half_index) const;
  /// The fraction of the way from hub to tip, 0 .. 2 elements.span: even to the end of the fillet, then graded.
  double span(int half_index, double fillet_end) const;
  /// The fraction of a splitter's own chord at that station; 0 upstream of the splitter.
  double splitter_chord(double station) const;
};

/// Reads the keys that all families share: element, clamped, the numbers of elements. plan.blades must be known.
void read_common(CaseTable& table, SectorPlan& plan, int fewest_along_chord);

/// Reads the same keys for a main blade without a disc.
void read_common_of_blade(CaseTable& table, SectorPlan& plan);

}  // namespace tiprub::mesh
