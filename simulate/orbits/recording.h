// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "simulate/march/rotor_at_speed.h"
#include "simulate/march/time_march.h"
#include "simulate/orbits/chatter_audit.h"
#include "simulate/orbits/energy_audit.h"
#include "simulate/response/response.h"

namespace tiprub {

/// Marches some revolutions and keeps what response.h5 holds of them.
class Recording {
 public:
  struct Grid {
    int samples_per_revolution;
    int revolutions;
    int casing_areas;
    double leftover;            ///< [m] penetrations above count as left over by the contact law
    double orders;              ///< engine orders up to it are the band of resolved frequencies
    int cycle_revolutions = 0;  ///< so many of the last ones keep the whole rotor's state at every sample
  };
  Recording(const TimeMarch& march, const RotorAtSpeed& rotor, const ContactLine& contact, const Grid& grid);

  /// One revolution; the normal displacements, each the mean over a sample's interval, for judging whether it is
  /// steady.
  Eigen::VectorXd revolution(TimeMarch& march);
  /// Fills in the arrays, the ledger and the counters.
  void finish(const TimeMarch& march, SpeedResponse& response) const;

 private:
  void take_states(const TimeMarch& march, int sample);
  void observe(const TimeMarch& march, int sample);
  void recover_displacements(int first_sample);
  double normal_amplitude() const;
  /// Keeps the state of a sample if no one before it met a larger contact force.
  void compare_force(int column, int sample);
  /// Adds the states of the revolution just done to the cycle, if it is one of the last.
  void keep_cycle();

  const RotorAtSpeed& rotor_;
  const ContactLine& contact_;
  Grid grid_;
  int sectors_, nodes_, width_;
  int done_ = 0;
  EnergyAudit audit_;
  ChatterAudit chatter_;
  std::vector<Eigen::MatrixXcd> states_;   ///< modal coordinates of the samples of a revolution; m x samples
  std::vector<Eigen::VectorXcd> hardest_;  ///< those of the sample with the largest contact force so far
  int hardest_sample_ = -1;
  std::vector<Eigen::MatrixXcd> cycle_;  ///< those of all samples of the last revolutions; m x samples
  SpeedResponse kept_;
  double pushing_ = 0, pulling_ = 0;  ///< [N] sums of the forces' magnitudes
};

/// One revolution without keeping anything but the normal displacements, each the mean over a sample's interval, so
/// that what swings faster than the samples isn't taken for something slow; width values a sector, sectors, samples.
Eigen::VectorXd march_revolution(TimeMarch& march, int samples_per_revolution);

}  // namespace tiprub
