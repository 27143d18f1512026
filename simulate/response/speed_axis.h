// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reduce/model/hdf5_file.h"
#include "simulate/response/response.h"

namespace tiprub {

/// The numbers of all speeds once more, along one axis of speed in the root of response.h5, for netCDF tools. Our
/// reader uses the groups of the speeds.
class SpeedAxis {
 public:
  void add(const SpeedResponse& speed);
  /// `rotor_speed` and one dataset along it for each number and each text. Raises RunError.
  void write(Hdf5File& file) const;

 private:
  struct Numbers {
    const char* name;
    const char* units;
    const char* long_name;
    std::vector<double> values;  ///< NaN where a speed has none
  };
  struct Texts {
    const char* name;
    const char* long_name;
    std::vector<std::string> values;
  };

  std::vector<double> speeds_;  ///< [rad/s]
  std::vector<Numbers> numbers_;
  std::vector<Texts> texts_;
};

}  // namespace tiprub
