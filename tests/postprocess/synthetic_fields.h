// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "reduce/model/fields_file.h"
#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub::postprocess::synthetic {

/// Full fields of the made rotor, and states whose stress is known in closed form.
///
/// A ring of bricks, six a sector, with the tip line on it. Under spin it widens evenly, u = spin_strain(Omega) (x,
/// y, 0), and the first generalized dof of nodal diameter 2 is an even pull along x and push along y, u = q (x, -y,
/// 0). Then the von Mises stress is the same at every point: with mu the shear modulus, 2 mu spin_strain of the spin
/// alone, 2 mu sqrt(3) |q| of the vibration alone, 2 mu sqrt(3 q^2 + spin_strain^2) of both.

/// [Pa] mu.
inline constexpr double shear_modulus = 40e9;
/// [1] at a speed in rad/s.
double spin_strain(double speed);
/// [1] q of the snapshot at a speed in rad/s.
double vibration_strain(double speed);

SectorFields sector_fields(const ReducedModel& model);
void write_fields(const ReducedModel& model, const std::filesystem::path& path);
/// The same with another sector of as many nodes.
void write_fields(const ReducedModel& model, const SectorFields& sector, const std::filesystem::path& path);
/// Gives every speed that has a motion its snapshot, at the sample with the largest contact force.
void add_snapshots(const ReducedModel& model, Response& response);

/// [1] of a cycle's q at a speed in rad/s: its mean, and the radius of the circle that q runs on around it.
double mean_strain(double speed);
double alternating_strain(double speed);
/// Gives every speed that has a motion a cycle of one revolution, q = mean_strain + alternating_strain e^{i phase}.
/// Its largest values are not at the sample with the largest contact force.
void add_cycles(const ReducedModel& model, Response& response);

}  // namespace tiprub::postprocess::synthetic
