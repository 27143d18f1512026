// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tiprub::postprocess {

/// The direction in which a wave runs over the sectors, seen from the rotor.
enum class WaveDirection {
  backward,  ///< against the rotation
  forward,   ///< with the rotation
  standing,  ///< nodal diameter 0 or N/2, which have no direction
};

/// How N sectors respond to a pattern that is fixed to the casing (paper, sec. 5.1.2, eq. 17, and its appendix, eq.
/// 18 to eq. 21).
///
/// Sector j sits at theta_abs = theta + j alpha + Omega t, alpha = 2 pi / N. A casing harmonic cos(k theta_abs)
/// excites it with cos(k j alpha + k Omega t) (eq. 21, where the paper writes p for k): at engine order k, with
/// the phase k j alpha over the sectors. At the N sectors this phase equals n j alpha with n = k mod N. Therefore
/// N oscillators m x_j'' + c x_j = f_j (eq. 18) respond in this one nodal diameter of their expansion (eq. 19;
/// eq. 20 for one engine order): table 1. The signed nodal diameter n of u_j(t) = Re(u
/// e^{i (omega t + n j alpha)}) with omega > 0 is taken in (-N/2, N/2]. A crest is at j alpha = -omega t / n:
/// n > 0 runs against the rotation (backward), n < 0 with it (forward). The paper's eq. 19 and eq. 20 use only
/// n >= 0, and do not distinguish the directions.

/// The signed nodal diameter in (-N/2, N/2] that engine order k excites: eq. 17 read from right to left. Requires
/// sector_count >= 1.
int signed_nodal_diameter(int engine_order, int sector_count);

/// The zig-zag of the paper's fig. 13: |signed_nodal_diameter|, in 0 .. floor(N/2).
int aliased_nodal_diameter(int engine_order, int sector_count);

/// Direction of a signed nodal diameter in (-N/2, N/2].
WaveDirection wave_direction(int signed_nodal_diameter, int sector_count);

/// "backward", "forward", "standing".
std::string name_of(WaveDirection direction);

}  // namespace tiprub::postprocess
