// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "simulate/motion/motion.h"
#include "simulate/response/response.h"

namespace tiprub {

/// The purpose of a file.
enum class ResponseUse {
  kept,     ///< the result of a sweep
  passing,  ///< a part of a sweep, soon read and removed: not compressed, without the axis of all speeds
};

/// Writes response.h5, schema "tiprub-response" version 5, speed by speed, because sweeps may not fit into memory.
/// The format is described in simulate/format.md. Speeds must ascend.
class ResponseWriter {
 public:
  ResponseWriter(const std::filesystem::path& path, const SimulatedScene& scene, const std::string& key,
                 const std::string& generator, ResponseUse use = ResponseUse::kept);
  ~ResponseWriter();

  void add(const SpeedResponse& speed);
  /// Once, before or after the speeds.
  void add(const FrequencyTable& frequencies);
  void add(const OrbitBranch& branch);
  /// The speeds that were scanned, and the amplitudes there (Response); once.
  void add_scanned(const Eigen::VectorXd& speeds, const Eigen::VectorXd& amplitudes);
  /// The state at the end of the last speed; for the parts of a sweep that starts each speed from the one before.
  void add_end(const RotorState& state);
  /// To be called last. Raises RunError if the file can't be written completely.
  void close();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The state of the seal at the end of a file.
enum class Seal {
  none,    ///< there is no seal
  broken,  ///< the bytes have changed since the file was sealed
  whole,   ///< the bytes are those that were sealed
};

/// Appends the digest of all bytes to a finished file; HDF5 ignores bytes after its own end. Raises RunError.
void seal(const std::filesystem::path& path);

Seal seal_of(const std::filesystem::path& path);

/// Also reads version 4. Raises RunError if the file is missing, damaged or of another schema, if its arrays do not
/// fit together, or if a number is out of bounds.
Response read_response(const std::filesystem::path& path);

/// The state that add_end() has written; at rest if there is none.
RotorState read_end_state(const std::filesystem::path& path);

/// Reads only the key. Raises RunError as read_response() does.
std::string read_response_key(const std::filesystem::path& path);

}  // namespace tiprub
