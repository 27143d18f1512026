// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/import_parameters.h"

#include <filesystem>
#include <optional>

#include "mesh/blades/length_unit.h"

namespace tiprub {

namespace {

constexpr int most_sectors = 1000;

/// By the file's ending, if the case doesn't say.
std::optional<MeshFormat> usual_format(const std::string& name) {
  const std::string end = std::filesystem::path(name).extension().string();
  if (end == ".inp") return MeshFormat::inp;
  if (end == ".bdf" || end == ".nas" || end == ".dat") return MeshFormat::bdf;
  if (end == ".cdb") return MeshFormat::cdb;
  if (end == ".unv") return MeshFormat::unv;
  return std::nullopt;
}

/// What can't be read here may still be read by gmsh.
void require_format(const CaseTable& table, const std::string& name) {
  if (table.has("mesh_format") || usual_format(name)) return;
  const std::filesystem::path path(name);
  const std::string end = path.extension().string();
  const std::string unv = std::filesystem::path(path).replace_extension(".unv").string();
  if (end == ".msh")
    table.reject("mesh_file",
                 "is gmsh's: tiprub-reduce takes it as it is, if it is in metres and its groups are named; "
                 "else write it as a format that is read here: gmsh " +
                     name + " -save -o " + unv);
  for (const char* cad : {".step", ".stp", ".iges", ".igs", ".brep", ".geo"})
    if (end == cad) table.reject("mesh_file", "has no mesh yet: gmsh " + name + " -3 -order 2 -o " + unv);
  table.reject("mesh_file", "doesn't end as a format that is known; name it: mesh_format = inp, bdf, cdb or unv");
}

}  // namespace

bool is_import(const CaseTable& table) {
  return table.has("mesh_file");
}

ImportParameters read_import_parameters(CaseTable& table) {
  ImportParameters parameters;
  parameters.file = table.file("mesh_file", "a mesh of another code");
  require_format(table, parameters.file.name);
  parameters.format = table.choice<MeshFormat>(
      "mesh_format", usual_format(parameters.file.name),
      {{"inp", MeshFormat::inp}, {"bdf", MeshFormat::bdf}, {"cdb", MeshFormat::cdb}, {"unv", MeshFormat::unv}});
  parameters.length = read_length_unit(table);
  parameters.axis = table.choice<Axis>("axis", Axis::z, {{"x", Axis::x}, {"y", Axis::y}, {"z", Axis::z}});
  parameters.sector_count = table.integer("sector_count", 0, Range::between(0, most_sectors), "sectors");
  parameters.clamped = table.text("clamped", std::nullopt);
  parameters.blade_tip = table.text("blade_tip", "");
  parameters.contact = table.text("contact", "");
  if (parameters.blade_tip.empty() && parameters.contact.empty())
    table.reject("clamped",
                 "needs beside it blade_tip, the faces of the main blade's tip, or contact, nodes along it");
  parameters.splitter_tip = table.text("splitter_tip", "");
  parameters.contact_splitter = table.text("contact_splitter", "");
  parameters.cyclic_low = table.text("cyclic_low", "");
  parameters.cyclic_high = table.text("cyclic_high", "");
  if (parameters.cyclic_low.empty() != parameters.cyclic_high.empty())
    table.reject(parameters.cyclic_low.empty() ? "cyclic_high" : "cyclic_low", "needs the other cut beside it");
  parameters.disc = table.text("disc", "");
  parameters.main_blade = table.text("main_blade", "");
  parameters.splitter = table.text("splitter", "");
  parameters.leading_edge = table.choice<LeadingEdge>(
      "leading_edge", LeadingEdge::low_z, {{"low_z", LeadingEdge::low_z}, {"high_z", LeadingEdge::high_z}});
  table.close();
  return parameters;
}

}  // namespace tiprub
