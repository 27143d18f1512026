// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

#include "simulate/march/cache_lines.h"
#include "simulate/march/contact_compliance.h"
#include "simulate/march/inner_impact.h"
#include "simulate/march/rotor_at_speed.h"
#include "simulate/march/step_coefficients.h"

namespace tiprub::simulate {

/// The constants of the march of one nodal diameter. Arrays hold the modes of the rotor first, then padding modes
/// that never move (r = k = 1, c = 0), so that loops run over whole vectors.
struct MarchedWave {
  int nodal_diameter = 0;
  WaveKind kind = WaveKind::travelling;
  double weight = 0;        ///< w_n: 1 for a standing wave, 2 for a travelling one
  Eigen::Index moving = 0;  ///< number of modes with mass, which come first; padded to whole vectors
  Eigen::Index sliding =
      0;  ///< number of modes with rows of sliding or of y, padded in the same way; 0 if there are none
  Eigen::ArrayXd omega;  ///< [rad/s]
  StepCoefficients coefficients;

  Eigen::Index modes() const { return omega.size(); }
};

/// [m sqrt(kg)] Modal coordinates of one nodal diameter, MarchedWave::modes() values. Valid until the next step.
struct ModalCoordinates {
  Eigen::Map<const Eigen::ArrayXd> real, imaginary;

  /// The first `count` modes as complex numbers.
  Eigen::VectorXcd head(Eigen::Index count) const;
};

/// The motion of the tips as a march follows it.
struct TipMotion {
  Eigen::VectorXd normal;  ///< [m] displacements along the normals, by node
  Eigen::VectorXd blades;  ///< [m] coordinates y of the blades, sector after sector; empty if the gap is linear
};

/// The modes of all nodal diameters of a march. Only this class knows their order in memory, that of wave_kernels.h:
/// real and imaginary parts are separate and padded to whole vectors. The forces of a step are applied to the modes
/// together with the next free step, because both read the same rows of Y.
class ModalWaves {
 public:
  /// The order of contact nodes in a vector of the march: sector after sector, each padded to `width` nodes.
  struct Nodes {
    int sector_count, sectors, symmetry, nodes;  ///< N, N/g, g, n_c
    std::size_t width;
  };
  /// What a march needs in addition to the displacements along the normals.
  struct Needs {
    bool friction = false;
    std::size_t coordinates = 0;  ///< p, number of coordinates y in a sector; 0 if the gap is linear
  };
  ModalWaves(const RotorAtSpeed& rotor, const SchemeOptions& scheme, double time_step, const Nodes& nodes,
             const Needs& needs);

  std::size_t size() const { return waves_.size(); }
  const MarchedWave& operator[](std::size_t wave) const { return waves_[wave]; }
  /// The coordinates q at t_q, their increments q - q- since t_{q-1}, and the increments of the step before.
  ModalCoordinates coordinates(std::size_t wave) const { return view(wave, &Memory::q); }
  ModalCoordinates increments(std::size_t wave) const { return view(wave, &Memory::increment); }
  ModalCoordinates increments_before(std::size_t wave) const { return view(wave, &Memory::increment_before); }
  /// [N] Lambda_n = (w_n g / N) sum_j lambda_j e^{-i n j alpha} of the forces that were added last; n_c.
  Eigen::VectorXcd forces(std::size_t wave) const;
  /// [m/N] W = sum over n of Re(Y c Y^H e^{i n (j - j') alpha}) w_n g / N; padded rows zero.
  Eigen::MatrixXd compliance(const RotorAtSpeed& rotor) const;
  /// W, and the other responses that ContactCompliance needs: the same sum with rows of sliding or of y in place of
  /// Y. `friction` as in MarchSetup.
  ContactCompliance::Responses responses(const RotorAtSpeed& rotor, const Eigen::VectorXd& friction) const;

  /// The recoil of each contact node of a sector and of its padding: <r> = (Y r c Y^H)/(Y c Y^H), and <k> in the same
  /// way, summed over n as W is. Only nodal diameters that are multiples of `symmetry` count, so that a symmetric
  /// motion is the same whether the others are marched or not.
  std::vector<Recoil> recoils(const RotorAtSpeed& rotor, int symmetry) const;

  void set_state(std::size_t wave, const Eigen::VectorXcd& q, const Eigen::VectorXcd& increment);
  /// Does the free step, and computes the motion after it.
  void advance(TipMotion& motion);
  /// Computes the motion after one more free step, which is not carried out.
  void look_ahead(TipMotion& motion);
  /// Computes the motion of the tips at t_q and at t_{q-1} from the modes.
  void map_to_sectors(TipMotion& motion, TipMotion& before);
  /// Computes the displacements S (q - q-) [m] along theta and along the tip line, alternately, in the step before
  /// the last advance().
  void slide(Eigen::VectorXd& displacement);
  /// Contact forces [N] on some nodes.
  struct Forces {
    const Eigen::VectorXd& normal;  ///< along -normal
    const Eigen::VectorXd& drag;    ///< along -theta and against e_m, alternately; zero on other nodes
    const Eigen::VectorXd& blades;  ///< in the direction of -y, sector after sector
    const std::vector<int>& nodes;  ///< nodes with a force, ascending
  };
  /// q+ -= c Y^H Lambda_n, and the same for the drag and the forces on y.
  void add_forces(const Forces& forces);
  /// Subtracts c Y^H Lambda_n of impulses [N] over a step from the increments only, as if the nodes had reached q+
  /// with another velocity.
  void add_impulses(const Forces& impulses);
  /// The change of the increments by the last add_impulses().
  ModalCoordinates jumps(std::size_t wave) const { return view(wave, &Memory::jump); }

 private:
  /// The rows of one nodal diameter that map its modes to displacements of the contact nodes in some directions, or
  /// to the coordinates y.
  struct Rows {
    kernels::Lines shapes;   ///< in the order of wave_kernels.h
    kernels::Lines by_mode;  ///< the same in the order of to_rows; only for sliding and blades
    std::size_t modes = 0;   ///< number of modes in by_mode, without padding
    Eigen::VectorXd forces;  ///< Lambda_n, real parts, then imaginary parts
  };
  /// The data that the rows of all nodal diameters share.
  struct Directions {
    std::size_t count = 0, width = 0;  ///< number of rows in a sector, without and with padding
    Eigen::VectorXd p;                 ///< Y q; for each wave real parts, then imaginary parts
    std::vector<int> forced;           ///< rows with a force in any sector
  };
  /// The working arrays of one nodal diameter.
  struct Memory {
    Eigen::VectorXd q, increment, increment_before, jump;  ///< real parts, then imaginary parts
    Rows normal, sliding, blades;
    Eigen::VectorXd cosine, sine;  ///< of n j alpha, by sector
  };
  Memory lay_out(const WaveModes& from, const MarchedWave& wave) const;
  void advance_modes(std::size_t wave);
  /// Computes the contribution of one wave to normal_.p and blades_.p from its modes.
  void map_to_tips(std::size_t wave, const Eigen::VectorXd& modes);
  void add_sectors(TipMotion& motion) const;
  /// The same for sliding_ or blades_.
  void map_to_rows(std::size_t wave, const Rows& rows, const Eigen::VectorXd& q, Directions& directions);
  ModalCoordinates view(std::size_t wave, Eigen::VectorXd Memory::*parts) const;
  void add_sectors(const Directions& directions, Eigen::VectorXd& displacement) const;
  /// Rows of a rotor, and the number of values per sector in the vectors of a march that belong to them.
  struct RowsOf {
    Eigen::MatrixXcd WaveModes::*rows;
    std::size_t width;
  };
  /// [m/N] The sum over n of (w_n g / N) Re(moved c pushed^H e^{i n (j - j') alpha}).
  Eigen::MatrixXd compliance(const RotorAtSpeed& rotor, const RowsOf& moved, const RowsOf& pushed) const;
  void settle_forces() const;
  /// Computes Lambda_n of forces.
  void gather(const Forces& forces);
  void gather(const Eigen::VectorXd& forces, const Directions& directions, Rows Memory::*rows);
  void add_waiting_forces(std::size_t wave) const { take_forces(wave, memory_[wave].q); }
  /// Subtracts the effect of Lambda_n from the increments, and from `other`.
  void take_forces(std::size_t wave, Eigen::VectorXd& other) const;
  void take_forces(std::size_t wave, const Rows& rows, const Directions& directions, Eigen::Index modes,
                   Eigen::VectorXd& other) const;

  Nodes nodes_;
  std::vector<MarchedWave> waves_;
  mutable std::vector<Memory> memory_;
  mutable bool forces_wait_ = false;       ///< whether the last forces have not been applied to the modes yet
  Eigen::VectorXd ahead_;                  ///< [m sqrt(kg)] coordinates of one nodal diameter after one more step
  Directions normal_, sliding_, blades_;   ///< the last two have no rows unless they are needed
  std::vector<double> phases_of_sectors_;  ///< for each sector and wave, the cosine and the sine of n j alpha
  std::vector<int> forced_sectors_;        ///< sectors with a force at any node
  std::vector<char> node_has_force_;
};

}  // namespace tiprub::simulate
