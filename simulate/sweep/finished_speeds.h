// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "cases/program/output_file.h"
#include "simulate/response/response_file.h"

namespace tiprub {

/// The speeds of a sweep that are done, each in a small response file of its own beside the output
/// ("response.h5.speeds/"), so that a sweep may be interrupted at any moment and loses only the speeds under way.
/// Parts of another key, damaged ones (a part is sealed) and leftovers are as good as none; other files in the folder
/// stay. A part also holds the state at its end, if the next speed starts from it. Not for several threads at once;
/// several processes may keep different speeds.
class FinishedSpeeds {
 public:
  enum class Role {
    keeper,       ///< cleans the folder, and takes over what is in it
    contributor,  ///< only adds
  };

  /// The keeper takes over what a former run left in the folder, and the speeds of a finished output of equal key.
  /// Raises RunError if the folder can't be made, the output not be written, or another run is writing it.
  FinishedSpeeds(const std::filesystem::path& output, SimulatedScene scene, std::string key, std::string generator,
                 Role role = Role::keeper);

  /// Whether the speed is there, looked at as deeply as it is wanted or deeper. A scan is kept beside what follows at
  /// its speed, and counts as itself alone: what a sweep does next hangs on it.
  bool has(double speed, Depth depth) const;
  /// Of a file with this sweep's scene and key.
  ResponseWriter writer(const std::filesystem::path& path, ResponseUse use = ResponseUse::kept) const;
  /// Written beside, then renamed. Raises RunError if it can't be written.
  void keep(const SpeedResponse& response, const RotorState& end = {});
  /// As it was scanned, or as it was computed in full.
  SpeedResponse read(double speed, Depth depth) const;
  /// At rest if the part holds none.
  RotorState read_end(double speed) const;
  /// Once the output stands, or never will.
  void remove();

 private:
  std::filesystem::path part(double speed, Depth depth) const;
  void note(double speed, Depth depth);
  bool take_over(const std::filesystem::path& file);
  void take_over_parts();
  void take_over_output(const std::filesystem::path& output);

  std::filesystem::path folder_;
  SimulatedScene scene_;
  std::string key_;
  std::string generator_;
  std::map<double, Depth> speeds_;  ///< in full, or examined
  std::set<double> scanned_;
  std::optional<OutputLock> lock_;  ///< the keeper's, on the output
};

}  // namespace tiprub
