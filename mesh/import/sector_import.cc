// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/sector_import.h"

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "cases/program/errors.h"
#include "cases/program/text.h"
#include "mesh/cells/cell_kind.h"
#include "mesh/curves/smooth_table.h"
#include "mesh/import/import_check.h"
#include "mesh/import/periodic_cuts.h"
#include "mesh/import/selection.h"

namespace tiprub::mesh {

namespace {

/// The reader of the format that a file's ending stands for.
std::optional<ReadMesh> usual_reader(const std::string& name) {
  static const std::map<std::string, ReadMesh> readers = {{".inp", read_inp}, {".bdf", read_bdf}, {".nas", read_bdf},
                                                          {".dat", read_bdf}, {".cdb", read_cdb}, {".unv", read_unv},
                                                          {".msh", read_msh}};
  const auto known = readers.find(std::filesystem::path(name).extension().string());
  return known == readers.end() ? std::nullopt : std::optional(known->second);
}

/// Refuses a file of an unknown format, and says how gmsh meshes one of a CAD system.
void require_format(const CaseTable& table, const std::string& name) {
  if (table.has("mesh_format") || usual_reader(name)) return;
  const std::filesystem::path path(name);
  const std::string end = path.extension().string();
  const std::string msh = std::filesystem::path(path).replace_extension(".msh").string();
  for (const char* cad : {".step", ".stp", ".iges", ".igs", ".brep", ".geo"})
    if (end == cad) table.reject("mesh_file", "has no mesh yet: gmsh " + name + " -3 -order 2 -o " + msh);
  table.reject("mesh_file",
               "doesn't end as a format that is known; name it: mesh_format = inp, bdf, cdb, unv or msh");
}

constexpr std::array part_keys = {"disc", "main_blade", "splitter"};
constexpr std::array selection_keys = {"clamped",    "blade_tip",   "contact", "splitter_tip", "contact_splitter",
                                       "cyclic_low", "cyclic_high", "disc",    "main_blade",   "splitter"};

constexpr int triangle6 = 9, quadrangle8 = 16, line2 = 1;  // gmsh's types

/// The solids, divided by the sets that the case names.
class Parts {
 public:
  Parts(const CellMesh& mesh, const ImportParameters& parameters) : part_(mesh.cells.size()) {
    for (const char* key : part_keys)
      if (const std::string& set = parameters.selection.at(key); !set.empty()) {
        const std::vector<int>& listed = select_cells(mesh, key, set);
        const std::set<int> cells(listed.begin(), listed.end());
        std::map<std::string, int> shared;  // by the part that has these solids already
        for (const int cell : cells)
          if (std::string& part = part_[static_cast<std::size_t>(cell)]; part.empty())
            part = key;
          else
            ++shared[part];
        if (shared.empty()) continue;
        const auto& [part, count] = *shared.begin();
        throw InputError(text_of(mesh.file, ": [mesh] ", part, " = \"", parameters.selection.at(part), "\" and ", key,
                                 " = \"", set, "\" have ", count, count == 1 ? " element" : " elements",
                                 " in common; each belongs to one part"));
      }
  }

  std::vector<NamedMesh::Entity> entities(const CellMesh& mesh) const {
    std::map<std::string, NamedMesh::Entity> by_part;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
      NamedMesh::Entity& entity = by_part.try_emplace(part_[c], NamedMesh::Entity{3, {"sector"}, {}}).first->second;
      const std::vector<int>& cell = mesh.cells[c];
      std::vector<std::size_t>& nodes = entity.elements[cell_kind(static_cast<int>(cell.size())).gmsh_type];
      nodes.insert(nodes.end(), cell.begin(), cell.end());
    }
    std::vector<NamedMesh::Entity> entities;
    for (auto& [part, entity] : by_part) {
      if (!part.empty()) entity.groups.push_back(part);
      entities.push_back(entity);
    }
    return entities;
  }

 private:
  std::vector<std::string> part_;  // of each solid; may be empty
};

NamedMesh::Entity surface(const CellMesh& mesh, const std::string& name, const std::vector<int>& faces) {
  NamedMesh::Entity entity{2, {name}, {}};
  for (const int f : faces) {
    const FreeFace& face = mesh.faces[f];
    std::vector<std::size_t>& nodes = entity.elements[face.corners() == 3 ? triangle6 : quadrangle8];
    nodes.insert(nodes.end(), face.nodes.begin(), face.nodes.end());
  }
  return entity;
}

using CutsIn = std::function<PeriodicCuts(const CellMesh&, int sector_count)>;

/// For a message: the axis and the number of sectors with which most faces of the cuts pair. Empty if there are none.
std::string where_cuts_pair(const ImportParameters& parameters, const CutsIn& cuts_in) {
  constexpr int any_count = 0;
  const ForeignMesh given = parameters.read(parameters.file);
  for (const int count : {parameters.sector_count, any_count})
    for (const auto& [axis, name] : {std::pair{Axis::z, "z"}, {Axis::y, "y"}, {Axis::x, "x"}}) {
      const CellMesh mesh = in_our_terms(given, parameters.length, axis);
      const PeriodicCuts cuts = cuts_in(mesh, count);
      if (could_be_meant(mesh, cuts))
        return "with axis = \"" + std::string(name) + "\" and sector_count = " + std::to_string(cuts.sector_count) +
               ", " + std::to_string(pairs_of(mesh, cuts).low.size()) + " faces are";
    }
  return "";
}

std::string where_found_cuts_pair(const ImportParameters& parameters) {
  return where_cuts_pair(parameters,
                         [](const CellMesh& given, int count) { return whole_cuts(given, find_cuts(given, count)); });
}

[[noreturn]] void refuse_cuts(const CellMesh& mesh, const ImportParameters& parameters) {
  const std::string other = where_found_cuts_pair(parameters);
  throw InputError(mesh.file + ": no face, turned by 360/" + std::to_string(parameters.sector_count) +
                   " degrees about the axis, is another one; " +
                   (other.empty() ? "is axis right, is the mesh on both cuts the same (gmsh: Periodic Surface), and "
                                    "sector_count the wheel's?"
                                  : other));
}

/// The cuts that a search finds.
PeriodicCuts found_cuts(const CellMesh& mesh, const ImportParameters& parameters) {
  const PeriodicCuts cuts = find_cuts(mesh, parameters.sector_count);
  if (cuts.low.empty() && parameters.sector_count > 1) refuse_cuts(mesh, parameters);
  require_whole(mesh, cuts);
  return cuts;
}

/// Why a mesh whose number of sectors and cuts the case leaves open may be understood wrongly, or empty.
std::string doubt_about(const CellMesh& mesh, const PeriodicCuts& cuts, const ImportParameters& parameters) {
  if (parameters.sector_count > 0 || !parameters.selection.at("cyclic_low").empty()) return "";
  if (!cuts.low.empty()) {  // these may be the flanks of a whole wheel's blades
    if (!goes_round(mesh)) return "";
    return "the mesh goes round the axis, and its faces that were taken for cuts may be the flanks of blades; set "
           "[mesh] sector_count = 1 if it is a whole wheel, or " +
           std::to_string(cuts.sector_count) + " if it is a sector";
  }
  const std::string other = where_found_cuts_pair(parameters),
                    none = "no face, turned about the axis, is another one";
  if (!other.empty())
    return none + "; " + other + ": set these, or, if this is one body without neighbours, sector_count = 1";
  if (goes_round(mesh)) return "";
  return none +
         ", so that this is one body without neighbours; if it is a sector, mesh both cuts alike (gmsh: Periodic "
         "Surface), else set [mesh] sector_count = 1";
}

/// The cuts that the case names.
PeriodicCuts cuts_by_name(const CellMesh& mesh, const ImportParameters& parameters) {
  const std::string &low_name = parameters.selection.at("cyclic_low"),
                    &high_name = parameters.selection.at("cyclic_high");
  const std::vector<int> low = select_faces(mesh, "cyclic_low", low_name),
                         high = select_faces(mesh, "cyclic_high", high_name);
  if (low == high)
    throw InputError(text_of(mesh.file, ": [mesh] cyclic_low = \"", low_name, "\" and cyclic_high = \"", high_name,
                             "\" select the same ", low.size(), low.size() == 1 ? " face" : " faces",
                             "; name one cut of the sector by each"));
  const CutsIn cuts_in = [&](const CellMesh& given, int count) { return named_cuts(given, low, high, count); };
  const PeriodicCuts cuts = cuts_in(mesh, parameters.sector_count);
  if (mostly_pair(mesh, cuts)) return cuts;
  const std::string other = where_cuts_pair(parameters, cuts_in);
  const std::size_t paired = pairs_of(mesh, cuts).low.size();
  const auto faces_of = [](const std::vector<int>& faces, const std::string& name) {
    return " " + std::to_string(faces.size()) + " faces of \"" + name + "\"";
  };
  const bool no_count = parameters.sector_count == 0 && cuts.sector_count == most_sectors;  // as at the same angle
  throw InputError(mesh.file + ": " + (paired == 0 ? "none" : std::to_string(paired)) + " of the" +
                   faces_of(low, low_name) + ", turned " +
                   (no_count ? "about the axis, " : "by 360/" + std::to_string(cuts.sector_count) + " degrees, ") +
                   (paired <= 1 ? "is" : "are") + " among the" + faces_of(high, high_name) + "; " +
                   (other.empty() ? why_unpaired(mesh, cuts) : other));
}

/// The cuts that the case names, or those that are found.
PeriodicCuts cuts_of(const CellMesh& mesh, const ImportParameters& parameters) {
  if (parameters.selection.at("cyclic_low").empty()) return found_cuts(mesh, parameters);
  const PeriodicCuts cuts = cuts_by_name(mesh, parameters);
  require_pairs(mesh, cuts);
  return cuts;
}

/// The tip of one blade.
struct Tip {
  std::string faces_key, line_key;  ///< keys of [mesh], and names of the groups
  std::vector<int> faces, line;     ///< the line from leading to trailing edge; without one there is no contact
};

Tip tip_of(const CellMesh& mesh, const ImportParameters& parameters, Tip tip) {
  const std::string &faces = parameters.selection.at(tip.faces_key), &line = parameters.selection.at(tip.line_key);
  if (faces.empty() && line.empty()) return tip;
  if (!faces.empty()) tip.faces = select_faces(mesh, tip.faces_key, faces);
  if (!faces.empty()) require_one_surface(mesh, tip.faces, tip.faces_key);
  tip.line = line.empty() ? line_along_tip(mesh, tip.faces, tip.faces_key, parameters.leading_edge)
                          : ordered_line(mesh, select_nodes(mesh, tip.line_key, line), parameters.leading_edge);
  if (tip.line.size() < 2)
    throw InputError(mesh.file + ": [mesh] " + tip.line_key +
                     " has one node in the meridional plane; it must run along the tip");
  if (!line.empty()) require_one_line(mesh, select_nodes(mesh, tip.line_key, line), tip.line, tip.line_key);
  if (!faces.empty() && !line.empty()) require_along_tip(mesh, tip.faces, tip.faces_key, tip.line, tip.line_key);
  return tip;
}

/// The parameters with the sets of the file that bear the name of a key in place of keys that are not given. A
/// splitter's tip by itself is only a name: contact there must be asked for.
ImportParameters with_own_names(ImportParameters p, const CellMesh& mesh) {
  for (auto& [key, name] : p.selection) name = mesh.set_named(name);
  const auto has = [&](const char* name) {
    const auto set = mesh.node_sets.find(mesh.set_named(name));
    return set != mesh.node_sets.end() && !set->second.empty();
  };
  for (const char* key : selection_keys) p.selection.try_emplace(key);
  const auto empty = [&](const char* key) { return p.selection.at(key).empty(); };
  const auto take = [&](const char* key) {
    if (empty(key) && has(key)) p.selection.at(key) = mesh.set_named(key);
  };
  take("contact");
  take("blade_tip");
  if (empty("splitter_tip")) take("contact_splitter");
  if (!empty("contact_splitter")) take("splitter_tip");
  if (empty("cyclic_low") && has("cyclic_low") && has("cyclic_high"))
    for (const char* cut : {"cyclic_low", "cyclic_high"}) p.selection.at(cut) = mesh.set_named(cut);
  for (const char* part : part_keys)
    if (mesh.cell_sets.contains(mesh.set_named(part))) take(part);
  if (empty("contact") && empty("blade_tip"))
    throw InputError(mesh.file +
                     ": [mesh] needs blade_tip, the faces of the main blade's tip, or contact, nodes along it; there "
                     "are the sets: " +
                     names_of_sets(mesh));
  return p;
}

std::string described(const CellMesh& mesh, const PeriodicCuts& cuts, const std::array<Tip, 2>& tips,
                      const std::vector<int>& clamped) {
  std::map<std::string, int> kinds;
  for (const std::vector<int>& cell : mesh.cells) ++kinds[cell_kind(static_cast<int>(cell.size())).name];
  std::ostringstream text;
  text << mesh.file << ": " << mesh.nodes.cols() << " nodes";
  for (const auto& [name, count] : kinds) text << ", " << count << " " << name;
  text << "\nradius up to " << mesh.largest_radius() << " m, z from " << mesh.nodes.row(2).minCoeff() << " to "
       << mesh.nodes.row(2).maxCoeff() << " m\n";
  if (cuts.low.empty())
    text << "no cuts: one body";
  else
    text << cuts.low.size() << " faces on cyclic_low, " << cuts.high.size() << " on cyclic_high, one of "
         << cuts.sector_count << " sectors";
  for (const Tip& tip : tips)
    if (!tip.line.empty())
      text << "\n"
           << tip.line_key << ": " << tip.line.size() << " nodes, from " << mesh.place_of(tip.line.front()) << " to "
           << mesh.place_of(tip.line.back());
  for (const Tip& tip : tips)
    if (!tip.faces.empty()) text << "\n" << tip.faces_key << ": " << extent_of(mesh, tip.faces);
  text << "\nclamped: " << extent_of(mesh, clamped);
  return text.str();
}

/// What a file holds that the import passes over although it changes the wheel, as lines.
std::string warnings_of(const ForeignMesh& file) {
  std::string text;
  const std::string kinds =
      listed(file.not_read, ", ", [](const auto& kind) { return text_of(kind.second, " ", kind.first); });
  if (!kinds.empty()) text += "\nwarning: not read: " + kinds + "; the sector lacks them";
  if (file.materials.size() > 1)
    text += text_of("\nwarning: ", file.materials.size(), " materials; tiprub-reduce takes the material of the case");
  return text;
}

}  // namespace

bool is_import(const CaseTable& table) {
  return table.has("mesh_file");
}

ImportParameters read_import_parameters(CaseTable& table) {
  ImportParameters parameters;
  const char* kind = "a mesh of another code";
  parameters.file = table.large_file("mesh_file", kind);
  require_format(table, parameters.file.name);
  parameters.read =
      table.choice("mesh_format", usual_reader(parameters.file.name),
                   {{read_inp, "inp"}, {read_bdf, "bdf"}, {read_cdb, "cdb"}, {read_unv, "unv"}, {read_msh, "msh"}});
  if (parameters.read != read_msh) require_utf8(parameters.file, kind);
  parameters.length = read_length_unit(table);
  parameters.axis = table.choice("axis", Axis::z, {{Axis::x, "x"}, {Axis::y, "y"}, {Axis::z, "z"}});
  parameters.sector_count = table.integer("sector_count", 0, Range::between(0, most_sectors), "sectors");
  for (const std::string key : selection_keys)
    parameters.selection[key] = table.text(key, key == "clamped" ? "clamped" : "");
  const bool low = parameters.selection["cyclic_low"].empty(), high = parameters.selection["cyclic_high"].empty();
  if (low != high) table.reject(low ? "cyclic_high" : "cyclic_low", "needs the other cut beside it");
  parameters.leading_edge = table.choice("leading_edge", LeadingEdge::low_z,
                                         {{LeadingEdge::low_z, "low_z"}, {LeadingEdge::high_z, "high_z"}});
  parameters.unusual = table.flag("unusual", false);
  table.close();
  return parameters;
}

void require_usual_radius(const CaseTable& table, const ImportParameters& parameters, double largest_radius) {
  constexpr double largest_usual = 5;  // [m]
  if (parameters.unusual || largest_radius <= largest_usual) return;
  table.reject(
      "length_unit",
      text_of("makes this a wheel of ", largest_radius, " m radius, which is unusual: expected at most ",
              largest_usual, " [m]; is the file in another unit? If it is meant, add unusual = true to this table"));
}

ImportedSector import_sector(const ImportParameters& given) {
  const ForeignMesh file = given.read(given.file);
  const CellMesh mesh = in_our_terms(file, given.length, given.axis);
  const ImportParameters parameters = with_own_names(given, mesh);
  const PeriodicCuts cuts = cuts_of(mesh, parameters);
  const std::array<Tip, 2> tips = {tip_of(mesh, parameters, {"blade_tip", "contact", {}, {}}),
                                   tip_of(mesh, parameters, {"splitter_tip", "contact_splitter", {}, {}})};
  const std::string doubt = doubt_about(mesh, cuts, parameters);
  if (!doubt.empty() && !parameters.selection.at("disc").empty()) throw InputError(mesh.file + ": " + doubt);
  const std::vector<int> clamped =
      off_the_cuts(mesh, cuts, select_faces(mesh, "clamped", parameters.selection.at("clamped")));
  require_held(mesh, pairs_of(mesh, cuts), clamped);
  ImportedSector sector;
  sector.largest_radius = mesh.largest_radius();
  for (const auto& node : mesh.nodes.colwise()) sector.mesh.nodes.emplace_back(node);
  sector.mesh.entities = Parts(mesh, parameters).entities(mesh);
  const auto add = [&](const std::string& name, const std::vector<int>& faces) {
    if (!faces.empty()) sector.mesh.entities.push_back(surface(mesh, name, faces));
  };
  add("cyclic_low", cuts.low);
  add("cyclic_high", cuts.high);
  add("clamped", clamped);
  for (const Tip& tip : tips) add(tip.faces_key, tip.faces);
  for (const Tip& tip : tips)
    if (!tip.line.empty())
      sector.mesh.entities.push_back({1, {tip.line_key}, {{line2, pieces_of({tip.line.begin(), tip.line.end()})}}});
  sector.description =
      described(mesh, cuts, tips, clamped) + (doubt.empty() ? "" : "\nwarning: " + doubt) + warnings_of(file);
  return sector;
}

}  // namespace tiprub::mesh
