// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "simulate/response.h"

namespace tiprub {

/// The speeds of a sweep that are done, each in a small response file of its own beside the output
/// ("response.h5.speeds/"), so that a sweep may be interrupted at any moment and loses only the speeds under way.
/// Parts of another key, damaged ones and leftovers are as good as none. Not for several threads at once.
class FinishedSpeeds {
 public:
  /// Takes over what a former run left in the folder, and the speeds of a finished output of equal key.
  /// Raises RunError if the folder can't be made.
  FinishedSpeeds(const std::filesystem::path& output, SimulatedScene scene, std::string key, std::string generator);

  bool has(double speed) const { return speeds_.count(speed) > 0; }
  /// Written beside, then renamed. Raises RunError if it can't be written.
  void keep(const SpeedResponse& response);
  SpeedResponse read(double speed) const;
  /// Once the output stands, or never will.
  void remove();

 private:
  std::filesystem::path part(double speed) const;
  void take_over_parts();
  void take_over_output(const std::filesystem::path& output);

  std::filesystem::path folder_;
  SimulatedScene scene_;
  std::string key_;
  std::string generator_;
  std::set<double> speeds_;
};

}  // namespace tiprub
