// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/sweep_rounds.h"

#include <functional>
#include <map>

#include "simulate/sweep/adaptive_speeds.h"
#include "simulate/sweep/missing_speeds.h"

namespace tiprub {

namespace {

class Rounds {
 public:
  Rounds(const StageArguments& arguments, const Scene& scene, int threads, ProcessGroup& group,
         FinishedSpeeds& finished)
      : arguments_(arguments), scene_(scene), threads_(threads), group_(group), finished_(finished) {}

  void run() {
    compute("speeds", scene_.parameters.speeds, Depth::full);
    const bool from_rest = scene_.parameters.sweep == SweepDirection::rest;
    if (from_rest && scene_.parameters.speed_choice == SpeedChoice::adaptive) locate();
    if (from_rest && scene_.parameters.examination == Examination::critical_speeds) examine();
  }
  SweepSpeeds speeds() const {
    SweepSpeeds found;
    for (const auto& [speed, amplitude] : full_) found.speeds.push_back(speed);
    found.scanned = scanned_.size();
    found.computed = computed_;
    return found;
  }

 private:
  void compute(const char* what, const std::vector<double>& speeds, Depth depth) {
    SpeedList list{what, {}};
    for (const double speed : speeds) list.tasks.push_back({speed, depth});
    computed_ += compute_missing(arguments_, scene_, list, threads_, group_, finished_);
    group_.together([&] {
      if (group_.leads()) note(speeds, depth);
    });
  }
  void note(const std::vector<double>& speeds, Depth depth) {
    for (const double speed : speeds)
      (depth == Depth::scanned ? scanned_ : full_)[speed] = finished_.read(speed, depth).amplitude;
  }
  void locate() {
    compute("scan", scan(), Depth::scanned);
    while (round("scan", Depth::scanned, [&] { return speeds_to_refine(curve(scanned_), goal().of_scan()); }))
      continue;
    round("peaks and jumps", Depth::full, [&] { return speeds_to_confirm(curve(scanned_), curve(full_), goal()); });
    while (round("peaks and jumps", Depth::full, [&] { return speeds_to_refine(curve(full_), goal()); })) continue;
  }
  /// Whether there was anything to compute; nothing that would go beyond speed_count_max.
  bool round(const char* what, Depth depth, const std::function<std::vector<double>()>& choose) {
    std::vector<double> next;
    if (group_.leads()) next = choose();
    const auto most = static_cast<std::size_t>(scene_.parameters.speed_count_max);
    if (group_.leads() && (depth == Depth::scanned ? scanned_ : full_).size() + next.size() > most) next.clear();
    group_.share(next);
    if (!next.empty()) compute(what, next, depth);
    return !next.empty();
  }
  void examine() {
    std::vector<double> peaks;
    if (group_.leads()) {
      const SampledCurve full = curve(full_);
      for (const std::size_t place : located_peaks(full, goal())) peaks.push_back(full[place].speed);
    }
    group_.share(peaks);
    if (!peaks.empty()) compute("examination of critical speeds", peaks, Depth::examined);
  }
  /// The given speeds and those between them.
  std::vector<double> scan() const {
    const std::vector<double>& given = scene_.parameters.speeds;
    std::vector<double> speeds = given;
    const int parts = scene_.parameters.scan_per_interval + 1;
    for (std::size_t i = 0; i + 1 < given.size(); ++i)
      for (int part = 1; part < parts; ++part) speeds.push_back(given[i] + (given[i + 1] - given[i]) * part / parts);
    return speeds;
  }
  using Amplitudes = std::map<double, double>;  ///< over speed
  static SampledCurve curve(const Amplitudes& amplitudes) {
    SampledCurve samples;
    for (const auto& [speed, amplitude] : amplitudes) samples.push_back({speed, amplitude});
    return samples;
  }
  LocationGoal goal() const {
    LocationGoal goal;
    goal.prominence = scene_.parameters.peak_prominence;
    return goal;
  }

  const StageArguments& arguments_;
  const Scene& scene_;
  int threads_;
  ProcessGroup& group_;
  FinishedSpeeds& finished_;
  Amplitudes full_, scanned_;  ///< the leader's
  std::size_t computed_ = 0;
};

}  // namespace

SweepSpeeds run_rounds(const StageArguments& arguments, const Scene& scene, int threads, ProcessGroup& group,
                       FinishedSpeeds& finished) {
  Rounds rounds(arguments, scene, threads, group, finished);
  rounds.run();
  return rounds.speeds();
}

}  // namespace tiprub
