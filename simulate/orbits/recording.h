// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <optional>
#include <vector>

#include "simulate/march/time_march.h"
#include "simulate/motion/motion.h"
#include "simulate/orbits/energy_audit.h"
#include "simulate/orbits/motion_class.h"

namespace tiprub::simulate {

/// Measures how much of the normal motion of the tips lies above the band of resolved frequencies. That is chatter of
/// modes that the mesh does not resolve.
class ChatterAudit {
 public:
  struct Share {
    double share = 0;  ///< [1] of the mean square without the mean, over all contact nodes
    int node = 0;      ///< contact node with most of it
  };

  ChatterAudit(const TimeMarch& march, const EngineOrderBand& band);
  /// To be called at each instant.
  void observe(const Eigen::VectorXd& displacement);
  /// To be called with the means over the intervals of the samples of each revolution.
  void add_revolution(const Eigen::VectorXd& motion);
  Share share() const;

 private:
  EngineOrderBand band_;
  int width_;
  double instants_ = 0, samples_ = 0;
  Eigen::ArrayXd sum_, squares_;  ///< [m], [m^2] over instants, by channel
  Eigen::ArrayXd band_squares_;   ///< [m^2] over samples
};

/// Some revolutions of a march, sample by sample, with the numbers collected on the way.
struct Recorded {
  int samples_per_revolution = 0;
  int revolutions = 0;
  Eigen::MatrixXd displacement;   ///< [m] r, theta, z; samples x (sector, node, component)
  Eigen::MatrixXd contact_force;  ///< [N] along -normal, means over the samples' intervals; samples x (sector, node)
  /// Number of steps in contact for each area of the casing; (sector, node) x areas.
  Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic> contact_count;
  RotorSnapshot snapshot;           ///< of the sample with the largest contact force
  std::optional<RotorCycle> cycle;  ///< if it was asked for
  double amplitude = 0;             ///< [m] half of the peak-to-peak normal displacement, the largest
  double largest_penetration = 0;   ///< [m] 0 if there is none
  double smallest_multiplier = 0;   ///< [N] below zero where the casing pulled
  std::int64_t contact_steps = 0;   ///< with at least one closed node
  std::int64_t tension_steps = 0;   ///< with a negative multiplier
  std::int64_t leftover_steps = 0;  ///< that leave a node clearly in the casing
  double tension_share = 0;         ///< [1] of the sum of the forces' magnitudes
  double left_out_energy = 0;       ///< [1] elastic energy of the modes without mass or dropped, of all of it
  EnergyLedger energy;
  FrictionLoad friction;
  ChatterAudit::Share chatter;
};

/// Marches some revolutions and records them.
class Recording {
 public:
  struct Grid {
    int samples_per_revolution;
    int revolutions;
    int casing_areas;
    double leftover;            ///< [m] larger penetrations after a step are counted
    double orders;              ///< highest engine order of the band of resolved frequencies
    int cycle_revolutions = 0;  ///< in this many last revolutions every sample of the whole rotor is kept
  };
  Recording(const TimeMarch& march, const Grid& grid);

  /// Marches one revolution. Returns its normal displacements as march_revolution() does.
  Eigen::VectorXd revolution(TimeMarch& march);
  /// Completes the recording and moves it out; to be called once.
  Recorded finish(const TimeMarch& march);

 private:
  void take_states(const TimeMarch& march, int sample);
  void observe(const TimeMarch& march, int sample);
  /// Adds the drag of a contact force.
  void add_drag(const TimeMarch& march, int sample, int index, double force);
  FrictionLoad friction_load(const TimeMarch& march) const;
  void recover_displacements(int first_sample);
  double normal_amplitude() const;
  /// Keeps the state of a sample if its contact force is the largest so far.
  void compare_force(int column, int sample);
  /// Adds the states of the present revolution to the cycle if it is one of the last.
  void keep_cycle();

  SharedRotor rotor_;
  ContactLine tips_;
  Grid grid_;
  int sectors_, nodes_, width_;
  int done_ = 0;
  EnergyAudit audit_;
  ChatterAudit chatter_;
  std::vector<Eigen::MatrixXcd> states_;   ///< modal coordinates of the samples of a revolution; m x samples
  std::vector<Eigen::VectorXcd> hardest_;  ///< modal coordinates at the sample with the largest contact force so far
  int hardest_sample_ = -1;
  std::vector<Eigen::MatrixXcd> cycle_;  ///< modal coordinates at all samples of the last revolutions; m x samples
  Recorded kept_;
  Eigen::MatrixXd drag_, torque_;  ///< [N], [N m] means over the samples' intervals; samples x sectors; with friction
  double pushing_ = 0, pulling_ = 0;  ///< [N] sums of the forces' magnitudes
};

/// Marches one revolution and returns its normal displacements, each the mean over the interval of a sample, so that
/// motion faster than the samples is not aliased. Sample after sample, as TimeMarch::displacement().
Eigen::VectorXd march_revolution(TimeMarch& march, int samples_per_revolution);

}  // namespace tiprub::simulate
