// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "simulate/motion/rotor_state.h"
#include "simulate/response/response.h"

namespace tiprub {

/// response.h5, schema "tiprub-response" version 5; the format is described in simulate/format.md.
void write_response(const Response& response, const std::filesystem::path& path, const std::string& generator);

/// What a file is written for.
enum class ResponseUse {
  kept,     ///< by people
  passing,  ///< a part of a sweep, soon read and removed: not packed, and without the axis of all speeds
};

/// The same file speed by speed, for sweeps that don't fit into memory. Speeds must come in ascending order.
class ResponseWriter {
 public:
  ResponseWriter(const std::filesystem::path& path, const SimulatedScene& scene, const std::string& key,
                 const std::string& generator, ResponseUse use = ResponseUse::kept);
  ~ResponseWriter();

  void add(const SpeedResponse& speed);
  /// Once, before or after the speeds.
  void add(const FrequencyTable& frequencies);
  void add(const OrbitBranch& branch);
  /// The state at the end of the last one; for the parts of a sweep that carries it on.
  void add_end(const RotorState& state);
  /// The last step: raises RunError if the disk doesn't take all of it.
  void close();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Reads version 4 too. Raises RunError if the file is missing, damaged, of another schema, its arrays don't fit
/// together, or a number is out of its bounds.
Response read_response(const std::filesystem::path& path);

/// What add_end() wrote; at rest if there is none.
RotorState read_end_state(const std::filesystem::path& path);

/// Only its key; raises as read_response() does.
std::string read_response_key(const std::filesystem::path& path);

}  // namespace tiprub
