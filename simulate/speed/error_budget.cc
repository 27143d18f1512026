// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/speed/error_budget.h"

#include <algorithm>
#include <array>
#include <complex>
#include <optional>
#include <string>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "simulate/march/march_state.h"
#include "simulate/motion/attempt.h"
#include "simulate/scene/friction_limit.h"
#include "simulate/speed/followed_peak.h"

namespace tiprub::simulate {

namespace {

constexpr double least_half_width = 2e-3, most_half_width = 1e-2;  // of the speed
constexpr double gap_beside = 0.2;   // of a half-width: the speeds at which two steps are compared
constexpr double still_there = 0.8;  // of the scanned height: the motion at the top is another one, beyond a jump
constexpr int retreats = 3;          // from a jump

/// The engine order with the largest mean square, over all contact nodes and directions.
int largest_order(const RecordedMotion& motion) {
  const int samples = motion.samples_per_revolution;
  Eigen::MatrixXd revolution = motion.displacement.topRows(samples);
  for (Eigen::Index first = samples; first < motion.displacement.rows(); first += samples)
    revolution += motion.displacement.middleRows(first, samples);
  Eigen::VectorXd squares = Eigen::VectorXd::Zero((samples - 1) / 2);
  Eigen::FFT<double> transform;
  for (Eigen::Index channel = 0; channel < revolution.cols(); ++channel) {
    const std::vector<double> signal(revolution.col(channel).begin(), revolution.col(channel).end());
    std::vector<std::complex<double>> spectrum;
    transform.fwd(spectrum, signal);
    for (Eigen::Index k = 0; k < squares.size(); ++k)
      squares[k] += std::norm(spectrum[static_cast<std::size_t>(k) + 1]);
  }
  Eigen::Index largest = 0;
  squares.maxCoeff(&largest);
  return static_cast<int>(largest) + 1;
}

/// The critical speed from which a peak is followed.
struct Origin {
  double speed;  ///< [rad/s]
  int order;     ///< the largest engine order there
};

/// [rad/s] Of the narrowest resonance, within reason.
double half_width_at(const Scene& scene, double speed) {
  return speed * std::clamp(scene.parameters.damping.smallest(), least_half_width, most_half_width);
}

/// The amplitude with a coarse step; negative where another engine order is the largest, which is that of another
/// peak. `failure` becomes the reason why a speed has no motion.
AmplitudeAt scanned(const Scene& scene, int order, std::string& failure) {
  return [&scene, order, &failure](double speed) -> std::optional<double> {
    if (speed <= 0 || speed > scene.model.speed_max) return std::nullopt;
    const auto motion =
        attempt([&] { return settle_roughly(scene, rotor_of(scene, speed, OtherDiameters::unknown)); });
    if (!motion.result) {
      failure = motion.failure;
      return std::nullopt;
    }
    const RecordedMotion& recorded = motion.result->recorded;
    return largest_order(recorded) == order ? recorded.amplitude : -recorded.amplitude;
  };
}

/// The states from which stress is computed: one period of a motion that repeats, all that was kept of another one.
std::optional<RotorCycle> stressed_cycle(const SettledMotion& motion, int lobes) {
  const int beats = motion.reading.period_beats, samples = motion.recorded.samples_per_revolution;
  if (!motion.recorded.cycle) return std::nullopt;
  RotorCycle cycle = *motion.recorded.cycle;
  cycle.first_sample = 0;  // the recording is of whole revolutions
  if (beats > 0 && samples % lobes == 0)
    for (Eigen::MatrixXcd& states : cycle.displacement)
      states.conservativeResize(Eigen::NoChange, std::min<Eigen::Index>(states.cols(), samples / lobes * beats));
  return cycle;
}

/// A speed marched within the tolerances from a state, which becomes that at the end.
PeakVariation marched_peak(const Scene& scene, double speed, RotorState& state) {
  const RefinedMotion found = settle_within_tolerance(scene, rotor_of(scene, speed), state, CycleChoice::kept);
  state = state_of(*found.motion.march, scene.model);
  const RecordedMotion& recorded = found.motion.recorded;
  PeakVariation peak;
  peak.speed = speed;
  peak.amplitude = recorded.amplitude;
  peak.excursion = largest_excursion(recorded.displacement, scene.model.contact);
  peak.motion = found.motion.reading.motion;
  peak.period_beats = found.motion.reading.period_beats;
  peak.samples_per_revolution = recorded.samples_per_revolution;
  peak.cycle = stressed_cycle(found.motion, scene.casing.lobes);
  return peak;
}

/// The peak near a speed, marched within the tolerances. Where the response jumps beside the top, the finer step may
/// have jumped already; a speed a little farther from the jump is taken then.
PeakVariation peak_near(const Scene& scene, const Origin& origin) {
  std::string failure;
  const auto scan = attempt([&] {
    return follow_peak({origin.speed, half_width_at(scene, origin.speed)}, scanned(scene, origin.order, failure));
  });
  if (!scan.result) throw NoMotion(scan.failure + (failure.empty() ? "" : "; some speeds fail: " + failure));
  const PeakTop& top = *scan.result;
  const double away = top.left.amplitude < top.right.amplitude ? top.right_gap() : -top.left_gap();
  PeakVariation peak;
  for (int i = 0; i <= (jumps(top) ? retreats : 0); ++i) {
    const double speed = jumps(top) ? top.top.speed + i * away : top.vertex();
    RotorState rest;
    const PeakVariation found = marched_peak(scene, speed, rest);
    if (found.amplitude > peak.amplitude) peak = found;
    if (peak.amplitude >= still_there * top.top.amplitude) break;
  }
  return peak;
}

/// A scene in which one thing is varied.
struct VariedScene {
  Variation what;
  double setting;
  Casing casing;
  SimulateParameters parameters;
  std::string refusal = {};             ///< empty, or why it can't be marched
  const ReducedModel* model = nullptr;  ///< null: that of the scene
};

VariedScene with_friction(const Scene& scene, double coefficient) {
  VariedScene varied{Variation::friction, coefficient, scene.casing, scene.parameters};
  varied.casing.friction = {{0.0, coefficient}};
  if (const FrictionLimit limit = friction_limit(scene.model); coefficient >= limit.coefficient)
    varied.refusal = limit.text();
  if (scene.parameters.contact == ContactRule::paper)
    varied.refusal = "friction needs forces that only push, and the paper's rule also lets them pull";
  return varied;
}

VariedScene with_damping(const Scene& scene, double ratio) {
  VariedScene varied{Variation::damping, ratio, scene.casing, scene.parameters};
  varied.parameters.damping.ratios = {.by_family = {ratio}, .beyond = scene.parameters.damping.ratios.beyond};
  return varied;
}

VariedScene with_clearance(const Scene& scene, double change) {
  VariedScene varied{Variation::clearance, change, scene.casing, scene.parameters};
  for (auto& [place, clearance] : varied.casing.clearance) {
    clearance += change;
    if (clearance <= 0) varied.refusal = "the clearance of the case is not larger than budget_clearance";
  }
  return varied;
}

/// The gap that the case does not ask for.
VariedScene with_other_gap(const Scene& scene) {
  const bool to_second = scene.parameters.gap != GapOrder::second_order;
  VariedScene varied{Variation::gap, to_second ? 2.0 : 1.0, scene.casing, scene.parameters};
  varied.parameters.gap = to_second ? GapOrder::second_order : GapOrder::linear;
  return varied;
}

VariedScene with_other_model(const Scene& scene) {
  const ContactLine& tips = scene.other_model->contact;
  const double segments = tips.kind == ContactKind::segments ? tips.size() - tips.splitter_nodes : 0;
  VariedScene varied{Variation::model, segments, scene.casing, scene.parameters};
  varied.model = scene.other_model;
  if (scene.parameters.gap == GapOrder::second_order && !tips.second_order)
    varied.refusal = "the other model does not hold the second order of the gap";
  return varied;
}

/// The scenes whose peaks are followed: a row of the budget each.
std::vector<VariedScene> varied_scenes(const Scene& scene) {
  const SimulateParameters& keys = scene.parameters;
  std::vector<VariedScene> scenes;
  const auto differs = [&](const auto& point) { return point[1] != keys.budget_friction; };
  if (std::ranges::any_of(scene.casing.friction, differs))
    scenes.push_back(with_friction(scene, keys.budget_friction));
  if (scene.model.contact.second_order) scenes.push_back(with_other_gap(scene));
  for (const double ratio : keys.budget_damping) scenes.push_back(with_damping(scene, ratio));
  for (const double sign : {-1.0, 1.0}) scenes.push_back(with_clearance(scene, sign * keys.budget_clearance));
  if (scene.other_model != nullptr) scenes.push_back(with_other_model(scene));
  return scenes;
}

PeakVariation followed(const Scene& scene, const VariedScene& varied, const Origin& origin) {
  Attempt<PeakVariation> found{std::nullopt, varied.refusal};
  if (varied.refusal.empty())
    found = attempt([&] {
      const ReducedModel& model = varied.model == nullptr ? scene.model : *varied.model;
      return peak_near({model, varied.casing, varied.parameters, scene.scope}, origin);
    });
  PeakVariation variation = found.result.value_or(PeakVariation{});
  if (varied.model != nullptr) variation.model_digest = digest(*varied.model);
  variation.what = varied.what;
  variation.setting = varied.setting;
  variation.failure = found.failure;
  return variation;
}

/// The speeds at and beside a critical speed.
using Beside = std::array<PeakVariation, 3>;

/// One of them, marched with a given step size.
PeakVariation marched_with(const Scene& scene, double speed, int steps_per_revolution, RotorState& state) {
  SimulateParameters parameters = scene.parameters;
  parameters.steps_per_revolution = steps_per_revolution;
  return marched_peak({scene.model, scene.casing, parameters, scene.scope}, speed, state);
}

/// The vertex of the parabola through three speeds, or the highest of them beside a jump.
double top_of(const Beside& at) {
  const auto sample = [&](std::size_t i) { return SampledSpeed{at[i].speed, at[i].amplitude}; };
  const PeakTop top{sample(0), sample(1), sample(2)};
  const bool encloses = top.top.amplitude > std::max(top.left.amplitude, top.right.amplitude);
  if (encloses && !jumps(top)) return top.vertex();
  return std::ranges::max_element(at, {}, &PeakVariation::amplitude)->speed;
}

/// The peak with half the step. The step moves a peak by far less than the speeds that find it are apart; the three
/// speeds at and beside the peak are therefore marched with both steps, and the tops of both curves compared.
PeakVariation with_half_step(const Scene& scene, double speed, int steps_per_revolution, Helpers* helpers) {
  const double gap = gap_beside * half_width_at(scene, speed);
  const auto found = attempt([&] {
    Beside whole, half;
    share(helpers, whole.size(), [&](std::size_t i) {
      const double there = speed + (static_cast<double>(i) - 1) * gap;
      RotorState state;
      whole[i] = marched_with(scene, there, steps_per_revolution, state);
      half[i] = marched_with(scene, there, 2 * steps_per_revolution, state);
    });
    PeakVariation peak = half[1];
    peak.speed = speed + top_of(half) - top_of(whole);
    return peak;
  });
  PeakVariation variation = found.result.value_or(PeakVariation{});
  variation.what = Variation::step;
  variation.setting = 2.0 * steps_per_revolution;
  variation.failure = found.failure;
  return variation;
}

}  // namespace

std::vector<PeakVariation> error_budget(const Scene& scene, double speed, const SettledMotion& motion,
                                        Helpers* helpers) {
  const Origin origin{speed, largest_order(motion.recorded)};
  const std::vector<VariedScene> varied = varied_scenes(scene);
  const bool halves = repeats(motion.reading.motion);  // others have no peak that is sharp enough
  std::vector<PeakVariation> rows(varied.size() + (halves ? 1 : 0));
  share(helpers, rows.size(), [&](std::size_t i) {
    rows[i] = i < varied.size() ? followed(scene, varied[i], origin)
                                : with_half_step(scene, speed, motion.march->steps_per_revolution(), helpers);
  });
  return rows;
}

}  // namespace tiprub::simulate
