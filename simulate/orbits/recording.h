// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "simulate/march/time_march.h"
#include "simulate/motion/motion.h"
#include "simulate/orbits/energy_audit.h"
#include "simulate/orbits/motion_class.h"

namespace tiprub::simulate {

/// Measures chatter: the share of the normal motion of the tips above the band of resolved frequencies, in modes that
/// the mesh does not resolve.
class ChatterAudit {
 public:
  struct Share {
    double share = 0;  ///< [1] of the mean square without the mean, over all contact nodes
    int node = 0;      ///< contact node with most of it
  };

  ChatterAudit(const TimeMarch& march, const EngineOrderBand& band);
  /// Adds the displacements at an instant; to be called at each instant.
  void observe(const Eigen::VectorXd& displacement);
  /// Adds a revolution: the means over the intervals of its samples.
  void add_revolution(const Eigen::VectorXd& motion);
  Share share() const;

 private:
  EngineOrderBand band_;
  int width_;
  double instants_ = 0, samples_ = 0;
  Eigen::ArrayXd sum_, squares_;  ///< [m], [m^2] sums over instants, by channel
  Eigen::ArrayXd band_squares_;   ///< [m^2] sum over samples
};

/// Marches some revolutions and records them. Refers to the march.
class Recording {
 public:
  struct Grid {
    int samples_per_revolution;
    int revolutions;
    int casing_areas;
    double leftover;            ///< [m] steps with a larger penetration are counted
    double orders;              ///< highest engine order of the band of resolved frequencies
    int cycle_revolutions = 0;  ///< number of last revolutions in which all samples of the whole rotor are kept
  };
  Recording(TimeMarch& march, const Grid& grid);

  /// Marches one revolution. Returns its normal displacements as march_revolution() does.
  Eigen::VectorXd revolution();
  /// Completes the recording and moves it out; to be called once.
  RecordedMotion finish();

 private:
  void take_states(int sample);
  void observe(int sample);
  /// Adds the drag due to a contact force [N] to the sample.
  void add_drag(int sample, int index, double force);
  FrictionLoad friction_load() const;
  void recover_displacements(int first_sample);
  double normal_amplitude() const;
  /// Keeps the state of a sample if its contact force is the largest so far.
  void compare_force(int column, int sample);
  /// Adds the states of the present revolution to the cycle if it is one of the last.
  void keep_cycle();

  TimeMarch& march_;
  Grid grid_;
  int done_ = 0;
  EnergyAudit audit_;
  ChatterAudit chatter_;
  std::vector<Eigen::MatrixXcd> states_;   ///< modal coordinates of the samples of a revolution; m x samples
  std::vector<Eigen::VectorXcd> hardest_;  ///< modal coordinates at the sample with the largest contact force so far
  int hardest_sample_ = -1;
  std::vector<Eigen::MatrixXcd> cycle_;  ///< modal coordinates at all samples of the last revolutions; m x samples
  RecordedMotion kept_;
  Eigen::MatrixXd drag_, torque_;  ///< [N], [N m] means over the samples' intervals; samples x sectors; with friction
  double pushing_ = 0, pulling_ = 0;  ///< [N] sums of the forces' magnitudes
};

/// Marches one revolution and returns its normal displacements, sample after sample, in the order of
/// TimeMarch::displacement(). Each value is the mean over the interval of its sample, so that motion faster than the
/// samples is not aliased.
Eigen::VectorXd march_revolution(TimeMarch& march, int samples_per_revolution);

}  // namespace tiprub::simulate
