// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/model/reduced_model.h"
#include "simulate/march/rotor_at_speed.h"
#include "simulate/march/time_march.h"
#include "simulate/scene/casing.h"
#include "simulate/scene/simulate_parameters.h"

namespace tiprub::simulate::testing {

/// A made-up wheel: every sector has `contact_nodes` masses of three dofs and `generalized` more, on random springs
/// (always the same), and is tied to its two neighbours, unsymmetrically, so that travelling waves are complex.
/// Frequencies are of the order of 1 to 10 kHz.
struct WheelPlan {
  int sectors = 6;
  int contact_nodes = 3;
  int generalized = 5;
};
ReducedModel synthetic_wheel(const WheelPlan& plan);

/// One mass [kg] on a spring [N/m] that moves along r only: N = 1, one contact node, no generalized dof.
ReducedModel one_mass(double mass, double stiffness);

/// N independent blades of one mass each, the same for every nodal diameter.
ReducedModel uncoupled_blades(int sectors, double mass, double stiffness);

/// A casing of cosine shape and even clearance.
Casing lobed_casing(int lobes, double amplitude, double clearance);

/// A motion that has settled to 1e-5, within 80 revolutions, with 0.5 % of damping.
SimulateParameters settling_parameters();

/// The nodal diameters 0 .. N/2.
std::vector<int> all_nodal_diameters(const ReducedModel& model);

/// A march of a rotor against a casing with the clearance [m] of its tips.
TimeMarch march_of(const RotorAtSpeed& rotor, const Casing& casing, const ContactLine& tips,
                   const Eigen::VectorXd& clearance, const MarchSetup& setup);

/// A march that plays with all nodal diameters, and the rotor it belongs to.
struct Bench {
  RotorAtSpeed rotor;
  TimeMarch march;
};
Bench make_bench(const ReducedModel& model, const Casing& casing, double speed, double damping_ratio,
                 const MarchSetup& setup);

/// The wheel of synthetic_wheel({}) with made-up terms of second order in its gap.
ReducedModel curved_wheel();

/// [m] Half of the peak-to-peak normal displacement over revolutions 21 and 22, the largest of all nodes.
double settled_amplitude(Bench bench);

}  // namespace tiprub::simulate::testing
