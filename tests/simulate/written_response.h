// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "simulate/response/response_file.h"

namespace tiprub {

/// Writes a whole response at once.
inline void write_response(const Response& response, const std::filesystem::path& path,
                           const std::string& generator) {
  ResponseWriter writer(path, response.scene, response.key, generator);
  if (response.frequencies.speed.size() > 0) writer.add(response.frequencies);
  for (const SpeedResponse& speed : response.speeds) writer.add(speed);
  for (const OrbitBranch& branch : response.branches) writer.add(branch);
  writer.add_scanned(response.scanned_speeds, response.scanned_amplitudes);
  writer.close();
}

}  // namespace tiprub
