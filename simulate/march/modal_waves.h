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

/// The data with which one nodal diameter is marched. The arrays hold the modes of the rotor first, then padding
/// modes that never move (r = k = 1, c = 0), so that loops run over whole vectors.
struct MarchedWave {
  int nodal_diameter = 0;
  WaveKind kind = WaveKind::travelling;
  double weight = 0;         ///< w_n: 1 for a standing wave, 2 for a travelling one
  Eigen::Index moving = 0;   ///< number of modes with mass, which come first, padded to whole vectors
  Eigen::Index sliding = 0;  ///< number of modes with rows beside those along the normals, likewise; 0 without any
  Eigen::ArrayXd omega;      ///< [rad/s]
  StepCoefficients coefficients;

  Eigen::Index modes() const { return omega.size(); }
};

/// [m sqrt(kg)] of one nodal diameter; MarchedWave::modes() values. Valid until the next step.
struct ModalCoordinates {
  Eigen::Map<const Eigen::ArrayXd> real, imaginary;

  /// The first `count` modes.
  Eigen::VectorXcd head(Eigen::Index count) const;
};

/// What a march follows of the motion of the tips.
struct TipMotion {
  Eigen::VectorXd normal;  ///< [m] displacements along the normals, by node
  Eigen::VectorXd blades;  ///< [m] coordinates y of the blades, sector after sector; empty if the gap is linear
};

/// The modes of all nodal diameters of a march. Only this class knows their memory order, which is that of
/// wave_kernels.h: real and imaginary parts are separate and padded to whole vectors. The forces of a step are
/// applied to the modes together with the next free step, because both read the same rows of Y.
class ModalWaves {
 public:
  /// The order of contact nodes in a vector of the march: sector after sector, each padded to `width` nodes.
  struct Nodes {
    int sector_count, sectors, symmetry, nodes;  ///< N, N/g, g, n_c
    std::size_t width;
  };
  /// What a march needs beside the displacements along the normals.
  struct Needs {
    bool friction = false;
    std::size_t coordinates = 0;  ///< p, of the blades of a sector
  };
  ModalWaves(const RotorAtSpeed& rotor, const SchemeOptions& scheme, double time_step, const Nodes& nodes,
             const Needs& needs);

  std::size_t size() const { return waves_.size(); }
  const MarchedWave& operator[](std::size_t wave) const { return waves_[wave]; }
  /// q at t_q, its increment q - q- since t_{q-1}, and that of the step before.
  ModalCoordinates coordinates(std::size_t wave) const;
  ModalCoordinates increments(std::size_t wave) const;
  ModalCoordinates increments_before(std::size_t wave) const;
  /// [N] Lambda_n = (w_n g / N) sum_j lambda_j e^{-i n j alpha} of the forces added last; n_c.
  Eigen::VectorXcd forces(std::size_t wave) const;
  /// [m/N] W = sum over n of Re(Y c Y^H e^{i n (j - j') alpha}) w_n g / N; padded rows zero.
  Eigen::MatrixXd compliance(const RotorAtSpeed& rotor) const;
  /// W and what ContactCompliance needs beside it: the same with other rows in place of Y. `friction` as in
  /// MarchSetup.
  ContactCompliance::Responses responses(const RotorAtSpeed& rotor, const Eigen::VectorXd& friction) const;

  /// Of each contact node of a sector and its padding: <r> = (Y r c Y^H)/(Y c Y^H), <k> likewise, summed over n as W.
  /// Only nodal diameters that are multiples of `symmetry` count, so that a symmetric motion is the same with the
  /// others and without.
  std::vector<Recoil> recoils(const RotorAtSpeed& rotor, int symmetry) const;

  void set_state(std::size_t wave, const Eigen::VectorXcd& q, const Eigen::VectorXcd& increment);
  /// The free step and the motion after it.
  void advance(TipMotion& motion);
  /// The motion after a further free step, which is not done.
  void look_ahead(TipMotion& motion);
  /// The motion of the modes as they are, and as they were a step ago.
  void map_to_sectors(TipMotion& motion, TipMotion& before);
  /// The displacements [m] S d along theta and along the tip line, in turn, over the step before the last advance().
  void slide(Eigen::VectorXd& displacement);
  /// Contact forces [N] on some nodes.
  struct Forces {
    const Eigen::VectorXd& normal;  ///< along -normal
    const Eigen::VectorXd& drag;    ///< along -theta and against the tip line, in turn; zero on other nodes
    const Eigen::VectorXd& blades;  ///< against y, sector after sector
    const std::vector<int>& nodes;  ///< those with a force, ascending
  };
  /// q+ -= c Y^H Lambda_n, and likewise with the drag and the forces against y.
  void add_forces(const Forces& forces);
  /// Takes c Y^H Lambda_n of impulses [N] over a step from the increments only, as if the nodes had come to q+ with
  /// another velocity.
  void add_impulses(const Forces& impulses);
  /// What the last add_impulses() has added to the increments.
  ModalCoordinates jumps(std::size_t wave) const;

 private:
  /// The displacements of the contact nodes in some directions, or the coordinates y, in one nodal diameter.
  struct Rows {
    kernels::Lines shapes;   ///< in the order of wave_kernels.h
    kernels::Lines by_mode;  ///< the same for to_rows; of sliding and of blades only
    std::size_t modes = 0;   ///< those of by_mode, without padding
    Eigen::VectorXd forces;  ///< Lambda_n, real parts, then imaginary parts
  };
  /// What the rows of all nodal diameters share.
  struct Directions {
    std::size_t count = 0, width = 0;  ///< rows in a sector, and padded
    Eigen::VectorXd p;                 ///< Y q, for each wave real parts, then imaginary parts
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
  /// Computes the share of one wave in normal_.p and blades_.p from its modes.
  void map_to_tips(std::size_t wave, const Eigen::VectorXd& modes);
  void add_sectors(TipMotion& motion) const;
  /// The same for sliding or blades.
  void map_to_rows(std::size_t wave, const Rows& rows, const Eigen::VectorXd& q, Directions& directions);
  ModalCoordinates view(std::size_t wave, Eigen::VectorXd Memory::*parts) const;
  void add_sectors(const Directions& directions, Eigen::VectorXd& displacement) const;
  /// The rows of a rotor that a march puts into vectors with `width` values a sector.
  struct RowsOf {
    Eigen::MatrixXcd WaveModes::*rows;
    std::size_t width;
  };
  /// w_n g / N times Re(moved c pushed^H e^{i n (j - j') alpha}) summed over n.
  Eigen::MatrixXd compliance(const RotorAtSpeed& rotor, const RowsOf& moved, const RowsOf& pushed) const;
  void settle_forces() const;
  /// Finds Lambda_n of forces.
  void gather(const Forces& forces);
  void gather(const Eigen::VectorXd& forces, const Directions& directions, Rows Memory::*rows);
  void add_waiting_forces(std::size_t wave) const { take_forces(wave, memory_[wave].q); }
  /// Takes the effect of Lambda_n from the increments, and from `other`.
  void take_forces(std::size_t wave, Eigen::VectorXd& other) const;
  void take_forces(std::size_t wave, const Rows& rows, const Directions& directions, Eigen::Index modes,
                   Eigen::VectorXd& other) const;

  Nodes nodes_;
  std::vector<MarchedWave> waves_;
  mutable std::vector<Memory> memory_;
  mutable bool forces_wait_ = false;       ///< the last forces are not in the modes yet
  Eigen::VectorXd ahead_;                  ///< [m sqrt(kg)] of one nodal diameter, after a further step
  Directions normal_, sliding_, blades_;   ///< the latter two without rows unless they are needed
  std::vector<double> phases_of_sectors_;  ///< for each sector and wave, the cosine and the sine of n j alpha
  std::vector<int> forced_sectors_;        ///< sectors with a force at any node
  std::vector<char> node_has_force_;
};

}  // namespace tiprub::simulate
