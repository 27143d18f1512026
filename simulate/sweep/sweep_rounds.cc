// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/sweep_rounds.h"

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
    for (const auto& [speed, sample] : curve_) {
      if (sample.kind == SampledSpeed::Kind::full) found.speeds.push_back(speed);
      found.scanned += sample.kind == SampledSpeed::Kind::scanned;
    }
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
      curve_[speed] = {speed, finished_.read(speed, depth).amplitude,
                       depth == Depth::scanned ? SampledSpeed::Kind::scanned : SampledSpeed::Kind::full};
  }
  void locate() {
    compute("scan", scan(), Depth::scanned);
    while (true) {
      std::vector<double> next;
      if (group_.leads()) next = speeds_to_refine(sampled(), goal());
      const auto most = static_cast<std::size_t>(scene_.parameters.speed_count_max);
      if (group_.leads() && speeds().speeds.size() + next.size() > most) next.clear();
      group_.share(next);
      if (next.empty()) return;
      compute("peaks and jumps", next, Depth::full);
    }
  }
  void examine() {
    std::vector<double> peaks;
    if (group_.leads()) {
      const std::vector<SampledSpeed> curve = computed_in_full();
      for (const std::size_t place : located_peaks(curve, goal())) peaks.push_back(curve[place].speed);
    }
    group_.share(peaks);
    if (!peaks.empty()) compute("examination of critical speeds", peaks, Depth::examined);
  }
  std::vector<double> scan() const {
    std::vector<double> speeds;
    const std::vector<double>& given = scene_.parameters.speeds;
    const int parts = scene_.parameters.scan_per_interval + 1;
    for (std::size_t i = 0; i + 1 < given.size(); ++i)
      for (int part = 1; part < parts; ++part) speeds.push_back(given[i] + (given[i + 1] - given[i]) * part / parts);
    return speeds;
  }
  std::vector<SampledSpeed> sampled() const {
    std::vector<SampledSpeed> samples;
    for (const auto& [speed, sample] : curve_) samples.push_back(sample);
    return samples;
  }
  std::vector<SampledSpeed> computed_in_full() const {
    std::vector<SampledSpeed> samples = sampled();
    std::erase_if(samples, [](const SampledSpeed& sample) { return sample.kind == SampledSpeed::Kind::scanned; });
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
  std::map<double, SampledSpeed> curve_;  ///< the leader's
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
