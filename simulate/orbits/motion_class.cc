// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/motion_class.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace tiprub::simulate {

namespace {

/// One channel over all revolutions in order, without its mean.
std::vector<double> signal_of(const std::deque<Eigen::VectorXd>& revolutions, Eigen::Index channels,
                              Eigen::Index channel) {
  std::vector<double> signal;
  for (const Eigen::VectorXd& revolution : revolutions)
    for (Eigen::Index i = channel; i < revolution.size(); i += channels) signal.push_back(revolution[i]);
  const double mean = std::accumulate(signal.begin(), signal.end(), 0.0) / static_cast<double>(signal.size());
  for (double& value : signal) value -= mean;
  return signal;
}

enum class Window { none, hann };

void apply_hann(std::vector<double>& signal) {
  const auto size = static_cast<double>(signal.size());
  for (std::size_t i = 0; i < signal.size(); ++i)
    signal[i] *= 1 - std::cos(2 * std::numbers::pi * static_cast<double>(i) / size);
}

/// The mean square of each line, summed over channels, up to engine order `orders`; line 0 stays zero.
Eigen::VectorXd lines_of(const std::deque<Eigen::VectorXd>& revolutions, Eigen::Index channels, double orders,
                         Window window) {
  const auto count = static_cast<double>(revolutions.size());
  const Eigen::Index samples = revolutions.front().size() / channels;
  const double resolved = static_cast<double>(samples - 1) / 2;
  const auto last = static_cast<Eigen::Index>(std::floor(std::min(orders, resolved) * count));
  Eigen::VectorXd lines = Eigen::VectorXd::Zero(last + 1);
  Eigen::FFT<double> transform;
  std::vector<std::complex<double>> spectrum;
  for (Eigen::Index channel = 0; channel < channels; ++channel) {
    std::vector<double> signal = signal_of(revolutions, channels, channel);
    if (window == Window::hann) apply_hann(signal);
    transform.fwd(spectrum, signal);
    for (Eigen::Index m = 1; m <= last; ++m) lines[m] += std::norm(spectrum[static_cast<std::size_t>(m)]);
  }
  return lines;
}

/// The energies of the lines that are more than `width` lines from all multiples of `spacing` lines.
std::vector<double> lines_beside(const Eigen::VectorXd& lines, double spacing, double width) {
  std::vector<double> beside;
  for (Eigen::Index m = 1; m < lines.size(); ++m) {
    const double place = static_cast<double>(m) / spacing;
    if (std::abs(place - std::round(place)) * spacing > width) beside.push_back(lines[m]);
  }
  return beside;
}

/// Their share of the energy.
double share_beside(const Eigen::VectorXd& lines, double spacing, double width) {
  const std::vector<double> beside = lines_beside(lines, spacing, width);
  const double all = lines.sum();
  return all > 0 ? std::accumulate(beside.begin(), beside.end(), 0.0) / all : 0.0;
}

/// Share of the lines off the beat that is needed for most of the energy off the beat.
double lines_for_most(const Eigen::VectorXd& lines, double spacing, double width) {
  std::vector<double> beside = lines_beside(lines, spacing, width);
  std::ranges::sort(beside, std::greater<>());
  const double wanted = ClassLimits::most_energy * std::accumulate(beside.begin(), beside.end(), 0.0);
  double sum = 0;
  std::size_t count = 0;
  while (count < beside.size() && sum < wanted) sum += beside[count++];
  return beside.empty() ? 0.0 : static_cast<double>(count) / static_cast<double>(beside.size());
}

}  // namespace

EngineOrderBand::EngineOrderBand(int samples, double orders)
    : orders_(static_cast<int>(std::min(std::max(orders, 1.0), (samples - 1) / 2.0))), samples_(samples) {
  if (orders_ >= (samples - 1) / 2) return;
  waves_.resize(samples, 2 * orders_ + 1);
  waves_.col(0).setConstant(1 / std::sqrt(samples));
  for (int k = 1; k <= orders_; ++k) {
    const double half = std::numbers::pi * k / samples;
    const double size = std::sqrt(2.0 / samples) * half / std::sin(half);
    for (int s = 0; s < samples; ++s) {
      const double angle = 2 * std::numbers::pi * (static_cast<long long>(k) * s % samples) / samples;
      waves_(s, 2 * k - 1) = size * std::cos(angle);
      waves_(s, 2 * k) = size * std::sin(angle);
    }
  }
}

Eigen::MatrixXd EngineOrderBand::coefficients(const Eigen::VectorXd& revolution) const {
  const Eigen::Map<const Eigen::MatrixXd> motion(revolution.data(), revolution.size() / samples_, samples_);
  return waves_.size() > 0 ? Eigen::MatrixXd(motion * waves_) : Eigen::MatrixXd(motion);
}

MotionReading read_motion(const std::deque<Eigen::VectorXd>& revolutions, Eigen::Index channels, double orders,
                          int lobes, Change change, double off_lines) {
  constexpr double rounding = 0.25;   // of a line
  constexpr double hann_width = 1.5;  // lines to each side that a line of Hann's window takes
  constexpr double between = 2;       // lines that two neighbours must leave, or nothing could contradict the period
  const bool settled = change == Change::settled;
  const Eigen::VectorXd lines = lines_of(revolutions, channels, orders, settled ? Window::none : Window::hann);
  const double width = settled ? rounding : hann_width;
  const double beat = static_cast<double>(revolutions.size()) * lobes;  // lines
  MotionReading reading;
  reading.off_beat_energy = share_beside(lines, beat, width);
  for (int k = 1; k <= ClassLimits::longest_period; ++k) {
    if (beat / k <= 2 * width + (settled ? 0 : between) || share_beside(lines, beat / k, width) > off_lines) continue;
    reading.period_beats = k;
    reading.motion = k == 1 ? MotionClass::periodic : MotionClass::subharmonic;
    return reading;
  }
  if (change == Change::decays) return reading;
  reading.motion =
      lines_for_most(lines, beat, width) < ClassLimits::few_lines ? MotionClass::modulated : MotionClass::broadband;
  return reading;
}

}  // namespace tiprub::simulate
