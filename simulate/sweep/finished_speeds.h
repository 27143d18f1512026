// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "cases/program/output_file.h"
#include "simulate/response/response_file.h"

namespace tiprub::simulate {

/// The finished speeds of a sweep, each in a small response file beside the output ("response.h5.speeds/"), so that a
/// sweep may be interrupted at any moment and loses only the speeds in progress. Parts with another key, damaged
/// parts (each is sealed) and leftovers are removed; other files in the folder stay. A part also holds its last state
/// if the next speed starts from it. Not safe for several threads at once; several processes may keep different
/// speeds.
class FinishedSpeeds {
 public:
  enum class Role {
    keeper,       ///< cleans the folder and takes over its parts
    contributor,  ///< only adds
  };

  /// The keeper takes over the parts of a former run, and the speeds of a finished output with the same key. Raises
  /// RunError if the folder can't be made, the output can't be written, or another run is writing it.
  FinishedSpeeds(const std::filesystem::path& output, SimulatedScene scene, std::string key, std::string generator,
                 Role role = Role::keeper);

  /// Whether the speed is there, computed as thoroughly as wanted or more. A scanned speed is kept beside a full one
  /// and is never replaced by it, because the next round of a sweep depends on it.
  bool has(double speed, Depth depth) const;
  /// Forgets a speed that is there, computed more thoroughly than this. Returns whether it was.
  bool forget_deeper(double speed, Depth depth);
  /// A writer of a file with the scene and the key of this sweep.
  ResponseWriter writer(const std::filesystem::path& path, ResponseUse use = ResponseUse::kept) const;
  /// Writes a part under a scratch name, then renames it. Raises RunError if it can't be written.
  void keep(const SpeedResponse& response, const RotorState& end = {});
  /// [m] NaN if the speed has failed. The part is not read again if this object kept it.
  double amplitude(double speed, Depth depth) const;
  /// Reads a part, scanned or full.
  SpeedResponse read(double speed, Depth depth) const;
  /// At rest if the part holds none.
  RotorState read_end(double speed) const;
  /// Removes all parts, once the output is written or the sweep has failed.
  void remove();

 private:
  std::filesystem::path part(double speed, Depth depth) const;
  void note(const SpeedResponse& response);
  bool take_over(const std::filesystem::path& file);
  void take_over_parts();
  void take_over_output(const std::filesystem::path& output);

  std::filesystem::path folder_;
  SimulatedScene scene_;
  std::string key_;
  std::string generator_;
  struct Kept {
    Depth depth;
    double amplitude;  ///< [m] NaN if it has failed
  };
  std::map<double, Kept> speeds_, scanned_;  ///< those that aren't scanned are full or more
  std::optional<OutputLock> lock_;           ///< the keeper's, on the output
};

}  // namespace tiprub::simulate
