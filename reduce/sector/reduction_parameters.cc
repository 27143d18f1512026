// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/reduction_parameters.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "cases/program/units.h"

namespace tiprub::reduce {

namespace {

constexpr double usual_accuracy = 0.02;
constexpr int most_modes = 500;

/// The part of a motion that the basis leaves out falls with the square of the basis' size (cases/price_of_accuracy).
int modes_for(double accuracy, int usual) {
  const double more = std::sqrt(std::max(1.0, usual_accuracy / accuracy));
  return std::min(static_cast<int>(std::lround(usual * more)), most_modes);
}

std::optional<ContactKind> read_contact(CaseTable& table) {
  using Contact = std::optional<ContactKind>;
  return table.choice(
      "contact", Contact(),
      {{Contact(), "automatic"}, {ContactKind::points, "points"}, {ContactKind::segments, "segments"}});
}

/// Refuses the keys that have no effect on a sector by its matrices, because a user would believe in their effect.
void require_keys_of_matrices(const CaseTable& table) {
  const auto refuse = [&](std::initializer_list<const char*> keys, const char* because) {
    for (const char* key : keys)
      if (table.has(key))
        table.reject(key, std::string("has no effect with --matrices, because ") + because + "; remove this key");
  };
  refuse({"young_modulus", "poisson_ratio", "density"}, "K and M hold the material");
  refuse({"prestress", "spin_softening", "polynomial_speeds", "polynomial_tolerance"},
         "K holds the effects of spin, at further speeds by --matrix-at");
  refuse({"refine", "element_order", "mesh_error"}, "the matrices come without cells");
}

Material read_material(CaseTable& table) {
  Material material;
  material.young = table.number("young_modulus", std::nullopt, Range::between(1.0, 1e15), "Pa");
  material.poisson = table.number("poisson_ratio", std::nullopt, Range::between(0.0, 0.49), "1");
  material.density = table.number("density", std::nullopt, Range::between(1e-3, 1e6), "kg/m^3");
  return material;
}

void read_spin(CaseTable& table, ReductionParameters& p) {
  p.prestress = table.choice(
      "prestress", Prestress::linear,
      {{Prestress::linear, "linear"}, {Prestress::stress_only, "stress_only"}, {Prestress::nonlinear, "nonlinear"}});
  p.spin_softening = table.flag("spin_softening", true) ? SpinSoftening::on : SpinSoftening::off;
}

void check_material(const CaseTable& table, const Material& material) {
  require_usual(table, "young_modulus", material.young, Range::between(1e8, 2e12), "Pa");
  require_usual(table, "density", material.density, Range::between(100, 25000), "kg/m^3");
}

void read_polynomial(CaseTable& table, ReductionParameters& p) {
  p.polynomial_speeds = table.integer("polynomial_speeds", 0, Range::between(0, 9),
                                      "of the shape under nonlinear spin, rest among them; 0: as many as it takes");
  p.polynomial_tolerance = table.number("polynomial_tolerance", 1e-4, {0.0, 1.0, Range::LowEnd::excluded},
                                        "of the load, out of balance between these speeds");
  if (p.polynomial_speeds == 1) table.reject("polynomial_speeds", "must be 0 (as many as it takes) or at least 2");
}

Degree read_degree(CaseTable& table) {
  constexpr int quadratic = 2, cubic = 3;
  const int order = table.integer("element_order", quadratic, Range::between(quadratic, cubic),
                                  "degree of the displacements; 3 for bricks only");
  return order == cubic ? Degree::cubic : Degree::quadratic;
}

void read_cells(CaseTable& table, ReductionParameters& p) {
  p.refine = table.integer("refine", 0, Range::between(0, 3), "times; each splits every cell into eight");
  p.degree = read_degree(table);
  p.mesh_error = table.flag("mesh_error", true);
}

Factorization read_factorization(CaseTable& table) {
  return table.choice("factorization", Factorization::automatic,
                      {{Factorization::automatic, "automatic"},
                       {Factorization::cholmod, "cholmod"},
                       {Factorization::mumps, "mumps"}});
}

}  // namespace

ReductionParameters read_reduction_parameters(CaseTable& table, SectorInput input) {
  ReductionParameters p;
  const bool is_mesh = input == SectorInput::mesh;
  if (!is_mesh) require_keys_of_matrices(table);
  const double accuracy =
      table.number("accuracy", usual_accuracy, Range::between(1e-5, 0.5), "of a critical speed's amplitude");
  if (is_mesh) p.material = read_material(table);
  p.speed_max = table.number("speed_max_rpm", std::nullopt, Range::between(1e-3, 1e8), "rpm") * rad_s_per_rpm;
  if (is_mesh) read_spin(table, p);
  p.contact = read_contact(table);
  if (!is_mesh && p.contact == ContactKind::segments)
    table.reject("contact",
                 "= \"segments\" needs the faces of the tip, which --matrices doesn't give; take \"points\"");
  p.contact_nodes = table.integer("contact_nodes", 10, Range::between(1, 200), "");
  p.fixed_interface_modes =
      table.integer("fixed_interface_modes", modes_for(accuracy, 40), Range::between(1, most_modes), "a speed");
  p.modes_at_speed =
      table.integer("modes_at_speed", modes_for(accuracy, 60), Range::between(0, 5000), "generalized dofs; 0: all");
  p.verification_speeds = table.numbers("verification_speeds", {{0.0, 0.15, 0.35, 0.6, 0.85, 0.95}},
                                        Range::between(0.0, 2.0), "of speed_max_rpm");
  p.frequency_tolerance = table.number("frequency_tolerance", accuracy / 40, {0.0, 1.0, Range::LowEnd::excluded},
                                       "of omega^2, at quarters of the top speed; what the basis misses joins it");
  if (is_mesh) read_polynomial(table, p);
  p.verification_modes = table.integer("verification_modes", 6, Range::between(1, 100), "a nodal diameter");
  if (std::ranges::adjacent_find(p.verification_speeds, std::greater_equal<>()) != p.verification_speeds.end())
    table.reject("verification_speeds", "must increase");
  p.verification_tolerance =
      table.number("verification_tolerance", 2e-5, {0.0, 1.0, Range::LowEnd::excluded}, "of omega^2, estimated");
  if (is_mesh) read_cells(table, p);
  p.cyclic_tolerance =
      table.number("cyclic_tolerance", 1e-6, {0.0, 0.01, Range::LowEnd::excluded}, "of the largest radius");
  p.unusual = table.flag("unusual", false);
  if (!p.unusual && is_mesh) check_material(table, p.material);
  p.factorization = read_factorization(table);
  p.threads = table.integer("threads", 2, Range::between(1, 256), "for nodal diameters and the BLAS");
  table.close();
  return p;
}

}  // namespace tiprub::reduce
