// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/import/periodic_cuts.h"

namespace tiprub::mesh {

/// Raises InputError if the cells form several bodies that share no node and one of them is not clamped: its
/// stiffness would be singular. The pairs of faces of the cuts hold bodies together, too. `clamped` are free faces.
void require_held(const CellMesh& mesh, const PeriodicCuts& pairs, const std::vector<int>& clamped);

/// The clamped faces that don't lie on a cut. Where two clamped surfaces meet at a cut, a face of the cut may have
/// all its corners in their set, and two of its edges are edges of clamped faces; such a face is left out. Raises
/// InputError if another face lies on a cut: the wheel would be held on a plane inside it.
std::vector<int> off_the_cuts(const CellMesh& mesh, const PeriodicCuts& cuts, const std::vector<int>& clamped);

/// Raises InputError, which names `key`, unless the faces of a tip are one surface without a sharp edge, of more than
/// 60 degrees between neighbouring faces. A curved tip turns by far less from face to face, a flank by about 90.
void require_one_surface(const CellMesh& mesh, const std::vector<int>& faces, const std::string& key);

/// Raises InputError, which names `key`, unless the given nodes form one line, of which `line` has those that
/// ordered_line() kept: none was left out beside another, and none makes the line turn back, as the nodes of a whole
/// tip do.
void require_one_line(const CellMesh& mesh, const std::vector<int>& nodes, const std::vector<int>& line,
                      const std::string& key);

/// Raises InputError, which names the keys, unless a given line runs along the whole tip: each of its nodes is one of
/// the faces', no face lies beyond an end of the line by more than one face (and 5 % of the line's length, for a
/// round edge meshed with small faces), and at most 30 % of the tip's area lies beyond the ends.
void require_along_tip(const CellMesh& mesh, const std::vector<int>& faces, const std::string& faces_key,
                       const std::vector<int>& line, const std::string& line_key);

/// Whether no quarter of a turn about the axis is free of nodes: as of a whole wheel, and of no sector.
bool goes_round(const CellMesh& mesh);

/// How many free faces these are, and from which to which radius: "26 faces, r 0.178 to 0.18 m".
std::string extent_of(const CellMesh& mesh, const std::vector<int>& faces);

}  // namespace tiprub::mesh
