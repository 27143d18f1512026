// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/finished_speeds.h"

#include <bit>
#include <cstdint>
#include <cstdio>
#include <utility>

#include "cases/program/errors.h"
#include "cases/program/output_file.h"

namespace fs = std::filesystem;

namespace tiprub {

FinishedSpeeds::FinishedSpeeds(const fs::path& output, SimulatedScene scene, std::string key, std::string generator,
                               Role role)
    : folder_(output.string() + ".speeds"),
      scene_(std::move(scene)),
      key_(std::move(key)),
      generator_(std::move(generator)) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) throw RunError(folder_.string() + ": can't be made: " + error.message());
  if (role == Role::contributor) return;
  take_over_parts();
  take_over_output(output);
}

/// Named by the bits of the speed: exact, and legible to nobody else.
fs::path FinishedSpeeds::part(double speed) const {
  char name[32];
  std::snprintf(name, sizeof(name), "%016llx.h5",
                static_cast<unsigned long long>(std::bit_cast<std::uint64_t>(speed)));
  return folder_ / name;
}

void FinishedSpeeds::take_over_parts() {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
    bool useful = false;
    try {
      const Response response = read_response(entry.path());
      useful =
          response.key == key_ && response.speeds.size() == 1 && part(response.speeds.front().speed) == entry.path();
      if (useful) speeds_[response.speeds.front().speed] = response.speeds.front().depth;
    } catch (const RunError&) {  // damaged: computed again
    }
    std::error_code ignored;
    if (!useful) fs::remove_all(entry.path(), ignored);
  }
}

void FinishedSpeeds::take_over_output(const fs::path& output) {
  if (!fs::exists(output)) return;
  Response response;
  try {
    if (read_response_key(output) != key_) return;
    response = read_response(output);
  } catch (const RunError&) {  // of another schema or damaged: it is replaced
    return;
  }
  for (const SpeedResponse& speed : response.speeds)
    if (!has(speed.speed, speed.depth)) keep(speed);
}

bool FinishedSpeeds::has(double speed, Depth depth) const {
  const auto place = speeds_.find(speed);
  return place != speeds_.end() && place->second >= depth;
}

ResponseWriter FinishedSpeeds::writer(const fs::path& path) const {
  return {path, scene_, key_, generator_};
}

void FinishedSpeeds::keep(const SpeedResponse& response, const RotorState& end) {
  OutputFile file(part(response.speed));
  ResponseWriter part_writer = writer(file.scratch());
  part_writer.add(response);
  part_writer.add_end(end);
  part_writer.close();
  file.commit();
  speeds_[response.speed] = response.depth;
}

RotorState FinishedSpeeds::read_end(double speed) const {
  return read_end_state(part(speed));
}

SpeedResponse FinishedSpeeds::read(double speed) const {
  return std::move(read_response(part(speed)).speeds.front());
}

void FinishedSpeeds::remove() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

}  // namespace tiprub
