// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/finished_speeds.h"

#include <bit>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <utility>

#include "cases/program/errors.h"
#include "cases/program/output_file.h"

namespace fs = std::filesystem;

namespace tiprub::simulate {

namespace {

constexpr std::size_t digits_of_a_speed = 16;
constexpr double no_amplitude = std::numeric_limits<double>::quiet_NaN();

double amplitude_of(const SpeedResponse& response) {
  return response.failure.empty() ? response.amplitude : no_amplitude;
}

/// Whether the name is that of a part or of its scratch file. Other files in the folder are not ours.
bool is_part(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  const std::size_t digits = name.find_first_not_of("0123456789abcdef");
  if (!entry.is_regular_file() || digits != digits_of_a_speed) return false;
  const std::string ending = name.substr(digits);
  return ending == ".h5" || ending == ".scan.h5" || ending == ".tiprub.part.h5" || ending == ".scan.tiprub.part.h5";
}

}  // namespace

FinishedSpeeds::FinishedSpeeds(const fs::path& output, SimulatedScene scene, std::string key, std::string generator,
                               Role role)
    : folder_(output.string() + ".speeds"),
      scene_(std::move(scene)),
      key_(std::move(key)),
      generator_(std::move(generator)) {
  if (role == Role::keeper) {
    lock_.emplace(output);
    const OutputFile writable(output);  // complains before the work, not after it
  }
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) throw RunError(folder_.string() + ": can't be made: " + error.message());
  if (role == Role::contributor) return;
  take_over_parts();
  take_over_output(output);
}

/// The name holds the bits of the speed, so that it is exact.
fs::path FinishedSpeeds::part(double speed, Depth depth) const {
  char name[32];
  std::snprintf(name, sizeof(name), "%016llx%s.h5",
                static_cast<unsigned long long>(std::bit_cast<std::uint64_t>(speed)),
                depth == Depth::scanned ? ".scan" : "");
  return folder_ / name;
}

/// Takes over a part if it is intact and belongs to this sweep. Returns whether it did.
bool FinishedSpeeds::take_over(const fs::path& file) {
  if (seal_of(file) != Seal::whole) return false;
  try {
    const Response response = read_response(file);
    if (response.key != key_ || response.speeds.size() != 1) return false;
    const SpeedResponse& only = response.speeds.front();
    if (part(only.speed, only.depth) != file) return false;
    note(only);
    return true;
  } catch (const FileError&) {  // damaged: computed again
    return false;
  }
}

void FinishedSpeeds::take_over_parts() {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
    if (is_part(entry) && !take_over(entry.path())) fs::remove(entry.path(), ignored);
}

void FinishedSpeeds::take_over_output(const fs::path& output) {
  if (!fs::exists(output)) return;
  Response response;
  try {
    if (read_response_key(output) != key_ || seal_of(output) != Seal::whole) return;
    response = read_response(output);
  } catch (const FileError&) {  // of another schema or damaged: it is replaced
    return;
  }
  for (const SpeedResponse& speed : response.speeds)
    if (!has(speed.speed, speed.depth)) keep(speed);
  for (Eigen::Index i = 0; i < response.scanned_amplitudes.size(); ++i) {
    const double amplitude = response.scanned_amplitudes[i];
    scanned_[response.scanned_speeds[i]] = {Depth::scanned, amplitude < 0 ? no_amplitude : amplitude};
  }
}

void FinishedSpeeds::note(const SpeedResponse& response) {
  (response.depth == Depth::scanned ? scanned_ : speeds_)[response.speed] = {response.depth, amplitude_of(response)};
}

bool FinishedSpeeds::has(double speed, Depth depth) const {
  const auto& kept = depth == Depth::scanned ? scanned_ : speeds_;
  const auto place = kept.find(speed);
  return place != kept.end() && place->second.depth >= depth;
}

bool FinishedSpeeds::forget_deeper(double speed, Depth depth) {
  const auto place = speeds_.find(speed);
  if (place == speeds_.end() || place->second.depth <= depth) return false;
  speeds_.erase(place);
  return true;
}

double FinishedSpeeds::amplitude(double speed, Depth depth) const {
  if (!has(speed, depth)) return amplitude_of(read(speed, depth));  // another process kept it
  return (depth == Depth::scanned ? scanned_ : speeds_).at(speed).amplitude;
}

ResponseWriter FinishedSpeeds::writer(const fs::path& path, ResponseUse use) const {
  return {path, scene_, key_, generator_, use};
}

void FinishedSpeeds::keep(const SpeedResponse& response, const RotorState& end) {
  OutputFile file(part(response.speed, response.depth));
  ResponseWriter part_writer = writer(file.scratch(), ResponseUse::passing);
  part_writer.add(response);
  part_writer.add_end(end);
  part_writer.close();
  file.commit();
  note(response);
}

RotorState FinishedSpeeds::read_end(double speed) const {
  return read_end_state(part(speed, Depth::full));
}

SpeedResponse FinishedSpeeds::read(double speed, Depth depth) const {
  return std::move(read_response(part(speed, depth)).speeds.front());
}

void FinishedSpeeds::remove() {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, ignored))
    if (is_part(entry)) fs::remove(entry.path(), ignored);
  fs::remove(folder_, ignored);
}

}  // namespace tiprub::simulate
