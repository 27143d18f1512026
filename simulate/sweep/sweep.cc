// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/sweep.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <iomanip>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "cases/program/errors.h"
#include "cases/program/machine.h"
#include "cases/program/output_file.h"
#include "cases/program/progress.h"
#include "cases/program/text.h"
#include "simulate/march/rotor_at_speed.h"
#include "simulate/motion/column.h"
#include "simulate/response/response_file.h"
#include "simulate/speed/speed_run.h"
#include "simulate/sweep/adaptive_speeds.h"
#include "simulate/sweep/branch_runs.h"
#include "simulate/sweep/finished_speeds.h"

namespace tiprub::simulate {

namespace {

constexpr double real_bytes = 8, complex_bytes = 16, bytes_per_gib = 1024.0 * 1024 * 1024;
constexpr double revolutions_to_judge_by = 32;  // normal displacements and their spectrum
constexpr double values_per_sample = 4;         // three displacements and a force of a contact node
constexpr double copies = 3;  // of a recording: in progress, before the last halving, and in the result

double modes_of(const Scene& scene) {
  double modes = 0;
  for (const int n : scene.scope.nodal_diameters)
    modes += static_cast<double>(scene.model.nodal_diameters[static_cast<std::size_t>(n)].M.rows());
  return modes;
}

/// [bytes] An estimate of the peak memory of a speed: samples, the states of a cycle, and the revolutions by which
/// its motion is judged.
double memory_of_speed(const Scene& scene) {
  const double samples = scene.scope.samples_per_revolution;
  const double recorded = samples * scene.parameters.recorded_revolutions;
  const double points = static_cast<double>(scene.scope.independent_sectors) * scene.model.contact.size();
  const bool cycle = scene.parameters.examination != Examination::none;
  const double states = complex_bytes * modes_of(scene) * (samples + (cycle ? copies * recorded : 0));
  return states + real_bytes * points *
                      (copies * values_per_sample * recorded + revolutions_to_judge_by * samples +
                       copies * scene.parameters.casing_areas);
}

/// Raises RunError if this many speeds at once need more memory than there is.
void require_memory(const Scene& scene, int threads, double available) {
  const double each = memory_of_speed(scene);
  if (threads * each <= available) return;
  throw RunError(text_of(
      std::setprecision(3), "not enough memory: about ", threads * each / bytes_per_gib, " GiB are needed (", threads,
      " speeds at once, ", each / bytes_per_gib, " GiB each), ", available / bytes_per_gib,
      " GiB are available; lower [simulate] samples_per_revolution, recorded_revolutions or casing_areas, or take "
      "fewer threads"));
}

/// A speed of a sweep and how thoroughly it is to be computed.
struct SpeedTask {
  double speed;  ///< [rad/s]
  Depth depth;
};

class Sweep {
 public:
  Sweep(const StageArguments& arguments, const Scene& scene, int threads, ProcessGroup& group)
      : arguments_(arguments), scene_(scene), threads_(threads), group_(group) {}

  SweepOutcome run(const SweepSettings& settings, const SceneOrigin& origin) {
    group_.together([&] { open(settings, origin); });
    compute_rounds();
    SweepOutcome outcome;
    outcome.computed = computed_;
    outcome.speeds = full_.size();
    outcome.scanned = scanned_.size();
    group_.together([&] {
      if (group_.leads()) assemble(outcome);
    });
    outcome.breaking = outcome.tally.breaking;
    if (scene_.parameters.when_symmetry_breaks == BrokenSymmetry::full_run) group_.share(outcome.breaking);
    return outcome;
  }

 private:
  using Amplitudes = std::map<double, double>;  ///< [m] over speed; NaN where it has failed

  // Begin and end
  void open(const SweepSettings& settings, const SceneOrigin& origin);
  std::vector<double> speeds() const;
  void assemble(SweepOutcome& outcome);

  // Rounds
  void compute_rounds();
  void compute(const char* what, const std::vector<double>& speeds, Depth depth);
  void compute(const char* what, const std::vector<SpeedTask>& tasks);
  void locate();
  void examine();
  void replace_deeper();
  bool round(const char* what, Depth depth, const std::function<std::vector<double>()>& choose);
  std::vector<double> scan() const;  ///< to begin with
  LocationGoal goal() const;
  int at_once() const;  ///< speeds that this process computes together
  Amplitudes& found(Depth depth) { return depth == Depth::scanned ? scanned_ : full_; }

  // Speeds
  Progress::Shown shown() const;
  std::vector<SpeedTask> missing_of(const std::vector<SpeedTask>& tasks);
  void compute_missing(const char* what, const std::vector<SpeedTask>& tasks);
  using Done = std::function<void(const SpeedResponse&, std::size_t place)>;
  void compute_together(const std::vector<SpeedTask>& missing, const Done& done);
  void carry(const std::vector<SpeedTask>& tasks, const std::function<void(const SpeedResponse&)>& done);

  const StageArguments& arguments_;
  const Scene& scene_;
  int threads_;
  ProcessGroup& group_;
  std::optional<FinishedSpeeds> finished_;
  Amplitudes full_, scanned_;      ///< of the leader only
  std::map<double, Depth> asked_;  ///< how thoroughly each of full_ is to be computed
  std::size_t computed_ = 0;
  bool cut_short_ = false;  ///< by speed_count_max
};

void Sweep::open(const SweepSettings& settings, const SceneOrigin& origin) {
  require_memory(scene_, at_once() * group_.local_size(), available_memory());
  const std::string generator = program_version("tiprub-simulate");
  finished_.emplace(arguments_.output, simulated_scene(scene_, origin),
                    run_key(scene_.model, settings, scene_.parameters, generator, scene_.other_model), generator,
                    group_.leads() ? FinishedSpeeds::Role::keeper : FinishedSpeeds::Role::contributor);
}

std::vector<double> Sweep::speeds() const {
  std::vector<double> speeds;
  for (const auto& [speed, amplitude] : full_) speeds.push_back(speed);
  return speeds;
}

/// Writes branches, natural frequencies and speeds to the response, and removes the parts.
void Sweep::assemble(SweepOutcome& outcome) {
  const std::vector<OrbitBranch> branches = follow_branches(scene_, speeds(), *finished_, shown());
  outcome.branches = branches.size();
  OutputFile file(arguments_.output);
  ResponseWriter writer = finished_->writer(file.scratch());
  writer.add(frequency_table(scene_.model, scene_.parameters.damping, speeds().back(), threads_));
  outcome.tally.crest = scene_.casing.crests(scene_.model.contact);
  outcome.tally.cut_short = cut_short_;
  for (const double speed : speeds()) {
    const SpeedResponse response = finished_->read(speed, Depth::full);
    outcome.tally.add(response);
    for (TermEffect& effect : term_effects(response, scene_.scope.nodal_diameters, scene_.model))
      outcome.effects.push_back(std::move(effect));
    writer.add(response);
  }
  for (const OrbitBranch& branch : branches) writer.add(branch);
  const auto speed = [](const auto& at) { return at.first; };
  const auto amplitude_or_negative = [](const auto& at) { return std::isnan(at.second) ? -1 : at.second; };
  writer.add_scanned(column(scanned_, speed), column(scanned_, amplitude_or_negative));
  writer.close();
  const bool all_failed = outcome.tally.failed == full_.size();
  if (!all_failed) file.commit();
  finished_->remove();
  if (all_failed) throw RunError("no speed could be computed; " + outcome.tally.first_failure);
}

void Sweep::compute_rounds() {
  compute("speeds", scene_.parameters.speeds, Depth::full);
  if (scene_.parameters.sweep != SweepDirection::rest) return;
  if (scene_.parameters.speed_choice == SpeedChoice::adaptive) locate();
  if (scene_.parameters.examination == Examination::critical_speeds) examine();
  replace_deeper();
}

/// Computes speeds again that an earlier run into the same file has examined, and this one has not: they would pass
/// for critical speeds.
void Sweep::replace_deeper() {
  for (const Depth depth : {Depth::full, Depth::examined}) {
    std::vector<double> speeds;
    for (const auto& [speed, asked] : asked_)
      if (asked == depth && finished_->forget_deeper(speed, depth)) speeds.push_back(speed);
    group_.share(speeds);
    if (!speeds.empty()) compute("speeds", speeds, depth);
  }
}

void Sweep::compute(const char* what, const std::vector<double>& speeds, Depth depth) {
  std::vector<SpeedTask> tasks;
  for (const double speed : speeds) tasks.push_back({speed, depth});
  compute(what, tasks);
}

void Sweep::compute(const char* what, const std::vector<SpeedTask>& tasks) {
  compute_missing(what, tasks);
  group_.together([&] {
    if (!group_.leads()) return;
    for (const auto& [speed, depth] : tasks) {
      found(depth)[speed] = finished_->amplitude(speed, depth);
      if (depth != Depth::scanned) asked_[speed] = depth;
    }
  });
}

/// Without the speeds that have failed: beside them the response neither rises nor falls.
SampledCurve curve(const std::map<double, double>& amplitudes) {
  SampledCurve samples;
  for (const auto& [speed, amplitude] : amplitudes)
    if (!std::isnan(amplitude)) samples.push_back({speed, amplitude});
  return samples;
}

void Sweep::locate() {
  compute("scan", scan(), Depth::scanned);
  while (round("scan", Depth::scanned, [&] { return speeds_to_refine(curve(scanned_), goal().of_scan()); })) continue;
  round("peaks and jumps", Depth::full, [&] { return speeds_to_confirm(curve(scanned_), curve(full_), goal()); });
  while (round("peaks and jumps", Depth::full, [&] { return speeds_to_refine(curve(full_), goal()); })) continue;
}

/// Computes a round, unless it would exceed speed_count_max. Returns whether there was anything to compute.
bool Sweep::round(const char* what, Depth depth, const std::function<std::vector<double>()>& choose) {
  std::vector<double> next;
  if (group_.leads()) next = choose();
  std::erase_if(next, [&](double speed) { return found(depth).contains(speed); });
  const auto most = static_cast<std::size_t>(scene_.parameters.speed_count_max);
  if (group_.leads() && found(depth).size() + next.size() > most) {
    cut_short_ = true;
    next.clear();
  }
  group_.share(next);
  if (!next.empty()) compute(what, next, depth);
  return !next.empty();
}

/// The largest peaks come first: an error budget costs as much as several speeds.
void Sweep::examine() {
  std::vector<double> peaks;
  if (group_.leads()) {
    const SampledCurve full = curve(full_);
    for (const std::size_t place : located_peaks(full, goal())) peaks.push_back(full[place].speed);
    std::ranges::stable_sort(peaks, [&](double a, double b) { return full_.at(a) > full_.at(b); });
  }
  group_.share(peaks);
  const BudgetChoice budget = scene_.parameters.budget;
  std::vector<SpeedTask> tasks;
  for (const double peak : peaks) {
    const bool budgeted =
        budget == BudgetChoice::critical_speeds || (budget == BudgetChoice::largest && tasks.empty());
    tasks.push_back({peak, budgeted ? Depth::budgeted : Depth::examined});
  }
  if (!tasks.empty()) compute("examination of critical speeds", tasks);
}

std::vector<double> Sweep::scan() const {
  const SimulateParameters& parameters = scene_.parameters;
  return speeds_to_scan(parameters.speeds, parameters.scan_per_interval, parameters.damping.smallest(),
                        static_cast<std::size_t>(parameters.speed_count_max));
}

LocationGoal Sweep::goal() const {
  LocationGoal goal = LocationGoal::of_damping(scene_.parameters.damping.smallest());
  goal.peaks.prominence = scene_.parameters.peak_prominence;
  return goal;
}

int Sweep::at_once() const {
  const SimulateParameters& parameters = scene_.parameters;
  if (parameters.sweep != SweepDirection::rest) return 1;
  if (parameters.speed_choice == SpeedChoice::adaptive) return threads_;
  return std::min(threads_, static_cast<int>(parameters.speeds.size()));
}

Progress::Shown Sweep::shown() const {
  return arguments_.verbosity == Verbosity::normal && group_.leads() ? Progress::Shown::on_a_terminal
                                                                     : Progress::Shown::never;
}

/// The tasks that the folder of the leader does not hold, for all processes.
std::vector<SpeedTask> Sweep::missing_of(const std::vector<SpeedTask>& tasks) {
  std::vector<double> places;  // in the list, as doubles, which processes can share
  for (std::size_t i = 0; i < tasks.size(); ++i)
    if (group_.leads() && !finished_->has(tasks[i].speed, tasks[i].depth)) places.push_back(static_cast<double>(i));
  group_.share(places);
  std::vector<SpeedTask> missing;
  missing.reserve(places.size());
  for (const double place : places) missing.push_back(tasks[static_cast<std::size_t>(place)]);
  return missing;
}

/// Shows a progress bar, or a line for each speed if verbose.
void Sweep::compute_missing(const char* what, const std::vector<SpeedTask>& tasks) {
  const std::vector<SpeedTask> missing = missing_of(tasks);
  group_.restart();
  Progress progress(what, missing.size(), shown());
  std::size_t seen = 0;  // speeds of other processes count once this one gets a later speed
  const Done done = [&](const SpeedResponse& response, std::size_t place) {
    for (const std::size_t end = std::max(seen, place) + 1; seen < std::min(end, missing.size()); ++seen)
      progress.advance();
    if (arguments_.verbosity == Verbosity::verbose) say(arguments_, speed_line(response));
  };
  if (scene_.parameters.sweep == SweepDirection::rest) {
    compute_together(missing, done);
  } else {
    group_.together([&] {
      if (group_.leads()) carry(tasks, [&](const SpeedResponse& response) { done(response, seen); });
    });
  }
  computed_ += missing.size();
}

/// Speeds are independent. Each thread of each process takes the next free speed and keeps its result at once, so
/// that results do not depend on the number of threads or processes. Threads for which none is left take a share of
/// the examinations that others make.
void Sweep::compute_together(const std::vector<SpeedTask>& missing, const Done& done) {
  std::mutex one_at_a_time;  // HDF5 and OutputFile are not safe for several threads
  std::exception_ptr failure;
  Helpers helpers;
  const auto take_speeds = [&] {
    for (std::size_t i = group_.next(); i < missing.size(); i = group_.next()) {
      try {
        const SpeedResponse response =
            simulate_speed(scene_, missing[i].speed, missing[i].depth, {}, &helpers).response;
        const std::lock_guard lock(one_at_a_time);
        if (failure) return;
        finished_->keep(response);
        done(response, i);
      } catch (...) {
        group_.stop();
        const std::lock_guard lock(one_at_a_time);
        if (!failure) failure = std::current_exception();
        return;
      }
    }
  };
  if (!missing.empty())
    work_together(threads_, [&] {
      helpers.begin();
      take_speeds();
      helpers.help();
    });
  group_.agree(failure);
}

/// Runs the speeds one after the other, upwards or downwards, in one process. The state kept with a finished speed
/// starts the next one, so that an interrupted sweep continues with equal bits.
void Sweep::carry(const std::vector<SpeedTask>& tasks, const std::function<void(const SpeedResponse&)>& done) {
  std::vector<SpeedTask> way = tasks;
  if (scene_.parameters.sweep == SweepDirection::down) std::ranges::reverse(way);
  const auto has = [&](const SpeedTask& task) { return finished_->has(task.speed, task.depth); };
  RotorState state;
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (has(way[i])) {
      if (i + 1 < way.size() && !has(way[i + 1])) state = finished_->read_end(way[i].speed);
      continue;
    }
    SpeedResult result = simulate_speed(scene_, way[i].speed, way[i].depth, state);
    finished_->keep(result.response, result.end);
    done(result.response);
    state = std::move(result.end);
  }
}

int thread_count(int asked_here, const SimulateParameters& parameters, const ProcessGroup& group) {
  if (asked_here > 0) return asked_here;
  if (parameters.threads > 0) return parameters.threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / group.local_size());
}

}  // namespace

SweepOutcome run_sweep(const StageArguments& arguments, const Scene& scene, const SweepSettings& settings,
                       const SceneOrigin& origin, int threads, ProcessGroup& group) {
  return Sweep(arguments, scene, thread_count(threads, scene.parameters, group), group).run(settings, origin);
}

}  // namespace tiprub::simulate
