// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/stress_over_speed.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <set>

#include "cases/program/machine.h"
#include "cases/program/signal_cleanup.h"
#include "cases/program/units.h"
#include "postprocess/fields/cell_stress.h"
#include "postprocess/fields/node_stress.h"
#include "postprocess/fields/wheel_cycle.h"
#include "reduce/model/dense_eigen.h"
#include "reduce/model/nodal_diameter.h"

namespace tiprub::postprocess {

namespace {

constexpr std::size_t nodes_of_a_speed = 6;
constexpr Eigen::Index most_blocked_modes = 40;
constexpr double loss_factor = 0.01;   // [1] eta
constexpr double small_wave = 1e-3;    // of the fastest one, by velocity
constexpr double small_stress = 0.01;  // of the most stressed wave
constexpr double counts_for_time = 0.1;
constexpr double least_window = 0.5;  // where stress is read through a window
constexpr int instants_of_a_period = 16;
constexpr Eigen::Index most_instants = 4096;

/// A nodal diameter in its contact dofs and its lowest modes with these blocked.
struct BlockedModes {
  int nodal_diameter = 0;
  SpeedPolynomial<Eigen::MatrixXcd, 0> K;
  Eigen::MatrixXcd M;
  Eigen::MatrixXcd stress;  ///< [Pa] of a unit of each of these dofs; (component, node) x dofs
};

BlockedModes blocked_modes(const NodalDiameterModel& model, int n, Eigen::Index contacts, double speed,
                           Eigen::MatrixXcd& basis) {
  const Eigen::Index dofs = model.M.rows(), inner = dofs - contacts, kept = std::min(inner, most_blocked_modes);
  basis = Eigen::MatrixXcd::Zero(dofs, contacts + kept);
  basis.topLeftCorner(contacts, contacts).setIdentity();
  if (inner > 0)
    basis.bottomRightCorner(inner, kept) =
        eigenpairs(Eigen::MatrixXcd(model.stiffness(speed).bottomRightCorner(inner, inner)),
                   Eigen::MatrixXcd(model.M.bottomRightCorner(inner, inner)))
            .vectors.leftCols(kept);
  BlockedModes modes{n, {}, basis.adjoint() * model.M * basis, {}};
  for (const Eigen::MatrixXcd& term : model.K.terms) modes.K.terms.emplace_back(basis.adjoint() * term * basis);
  return modes;
}

/// The contact dofs of the travelling wave of a nodal diameter at every sample: x of u_j = Re(x e^{i n j alpha}).
Eigen::MatrixXcd contact_wave(const SpeedResponse& response, const SimulatedScene& scene, int n) {
  const int held = scene.independent_sectors;
  const Eigen::Index dofs = response.displacement.cols() / held;
  Eigen::MatrixXcd wave = Eigen::MatrixXcd::Zero(dofs, response.displacement.rows());
  const double both_signs = is_standing(n, scene.sector_count) ? 1 : 2;
  for (int j = 0; j < held; ++j)
    wave += both_signs / held * std::conj(sector_phase(n, j, scene.sector_count)) *
            response.displacement.middleCols(j * dofs, dofs).transpose().cast<std::complex<double>>();
  return wave;
}

/// Whether a recording holds whole periods of its motion, so that its Fourier lines are the motion's own.
bool holds_whole_periods(const SpeedResponse& response) {
  return response.settled() && response.recorded_revolutions % response.period_revolutions == 0;
}

/// [1] Hann's window at a share of the recording. Its spectrum falls so fast that the two ends of a motion that does
/// not repeat, which differ, leave no lines at the high frequencies where blocked modes resonate.
double window(double share) {
  return 0.5 - 0.5 * std::cos(2 * std::numbers::pi * share);
}

/// A wave with the stress [Pa] that it makes; (component, node).
struct StressWave {
  int nodal_diameter = 0;
  double engine_order = 0;
  Eigen::VectorXcd stress;
};

class SpeedStress {
 public:
  SpeedStress(const SimulatedScene& scene, const std::vector<BlockedModes>& modes) : scene_(scene), modes_(modes) {}

  /// [Pa] at each of the nodes.
  Eigen::VectorXd largest(const SpeedResponse& response, Eigen::Index nodes) const {
    const std::vector<StressWave> waves = without_small(waves_of(response));
    Eigen::VectorXd largest = Eigen::VectorXd::Zero(nodes);
    if (waves.empty()) return largest;
    double highest = 1;
    for (const StressWave& wave : waves)
      if (wave.stress.norm() > counts_for_time * waves.front().stress.norm())
        highest = std::max(highest, std::abs(wave.engine_order));
    const int revolutions = response.recorded_revolutions;
    const Eigen::Index instants = std::min<Eigen::Index>(
        most_instants, static_cast<Eigen::Index>(std::ceil(instants_of_a_period * highest * revolutions)));
    Eigen::MatrixXd phases(2 * static_cast<Eigen::Index>(waves.size()), instants);
    for (Eigen::Index s = 0; s < instants; ++s) {
      const double share = static_cast<double>(s) / static_cast<double>(instants), here = window(share);
      const double factor = holds_whole_periods(response) ? 1 : here < least_window ? 0 : 1 / here;
      for (std::size_t w = 0; w < waves.size(); ++w) {
        const double angle = 2 * std::numbers::pi * revolutions * waves[w].engine_order * share;
        phases.col(s).segment<2>(2 * static_cast<Eigen::Index>(w)) << factor * std::cos(angle),
            factor * std::sin(angle);
      }
    }
    for (int j = 0; j < scene_.independent_sectors; ++j) {
      const Eigen::MatrixXd stress = parts_on(waves, j) * phases;
      const Eigen::VectorXd now = von_mises(stress.reshaped(6, stress.size() / 6));
      largest = largest.cwiseMax(now.reshaped(nodes, instants).rowwise().maxCoeff());
    }
    return largest;
  }

 private:
  /// The most stressed first.
  static std::vector<StressWave> without_small(std::vector<StressWave> waves) {
    std::ranges::stable_sort(waves, std::greater(), [](const auto& wave) { return wave.stress.squaredNorm(); });
    std::erase_if(waves, [least = waves.empty() ? 0 : small_stress * waves.front().stress.norm()](
                             const StressWave& wave) { return wave.stress.norm() <= least; });
    return waves;
  }

  /// The factors of cosine and sine of each wave on a sector.
  Eigen::MatrixXd parts_on(const std::vector<StressWave>& waves, int sector) const {
    Eigen::MatrixXd parts(waves.front().stress.size(), 2 * static_cast<Eigen::Index>(waves.size()));
    for (std::size_t w = 0; w < waves.size(); ++w) {
      const Eigen::VectorXcd here =
          sector_phase(waves[w].nodal_diameter, sector, scene_.sector_count) * waves[w].stress;
      parts.col(2 * static_cast<Eigen::Index>(w)) = here.real();
      parts.col(2 * static_cast<Eigen::Index>(w) + 1) = -here.imag();
    }
    return parts;
  }

  std::vector<StressWave> waves_of(const SpeedResponse& response) const {
    std::vector<StressWave> waves;
    const double highest = scene_.resolved_frequency / (response.speed * hz_per_rad_s);
    std::vector<Eigen::MatrixXcd> lines;
    double fastest = 0;
    const auto order_of = [&](Eigen::Index line, Eigen::Index samples) {
      return static_cast<double>(2 * line > samples ? line - samples : line) / response.recorded_revolutions;
    };
    const auto velocity = [](double order, double size) { return (1 + std::abs(order)) * size; };
    for (const BlockedModes& modes : modes_) {
      Eigen::MatrixXcd wave = contact_wave(response, scene_, modes.nodal_diameter);
      if (!holds_whole_periods(response))
        for (Eigen::Index s = 0; s < wave.cols(); ++s)
          wave.col(s) *= window(static_cast<double>(s) / static_cast<double>(wave.cols()));
      lines.push_back(fourier_lines(std::move(wave), 0));
      for (Eigen::Index m = 0; m < lines.back().cols(); ++m)
        fastest = std::max(fastest, velocity(order_of(m, lines.back().cols()), lines.back().col(m).norm()));
    }
    for (std::size_t i = 0; i < modes_.size(); ++i)
      for (Eigen::Index m = 0; m < lines[i].cols(); ++m) {
        const double order = order_of(m, lines[i].cols());
        if (std::abs(order) <= highest && velocity(order, lines[i].col(m).norm()) > small_wave * fastest)
          waves.push_back({modes_[i].nodal_diameter, order,
                           modes_[i].stress * condensed(modes_[i], response.speed, order, lines[i].col(m))});
      }
    return waves;
  }

  /// All dofs of a wave from its contact dofs.
  static Eigen::VectorXcd condensed(const BlockedModes& modes, double speed, double order,
                                    const Eigen::VectorXcd& contact) {
    const Eigen::Index inner = modes.M.rows() - contact.size();
    const double omega = order * speed;
    const Eigen::MatrixXcd K = modes.K(speed), dynamic = K - omega * omega * modes.M;
    Eigen::VectorXcd all(modes.M.rows());
    all.head(contact.size()) = contact;
    const std::complex<double> loss(0, order < 0 ? -loss_factor : loss_factor);
    all.tail(inner) =
        -Eigen::MatrixXcd(dynamic.bottomRightCorner(inner, inner) + loss * K.bottomRightCorner(inner, inner))
             .partialPivLu()
             .solve(dynamic.bottomLeftCorner(inner, contact.size()) * contact);
    return all;
  }

  const SimulatedScene& scene_;
  const std::vector<BlockedModes>& modes_;
};

}  // namespace

std::vector<int> stressed_nodes(const CycleStress& stress, const StressZones& zones) {
  std::vector<int> body;
  for (int node = 0; node < stress.vibration.size(); ++node)
    if (zones.at_node[static_cast<std::size_t>(node)] == StressZone::body) body.push_back(node);
  const auto count = static_cast<std::ptrdiff_t>(std::min(nodes_of_a_speed, body.size()));
  std::partial_sort(body.begin(), body.begin() + count, body.end(),
                    [&](int a, int b) { return stress.vibration[a] > stress.vibration[b]; });
  body.resize(static_cast<std::size_t>(count));
  return body;
}

std::vector<int> governing_nodes(const CycleStress& stress, const StressZones& zones,
                                 const std::optional<MaterialStrength>& strength) {
  std::vector<int> nodes = {static_cast<int>(largest_in(StressZone::body, zones, stress.vibration))};
  if (!strength) return nodes;
  const Eigen::VectorXd utilisation = goodman_utilisation(*strength, stress.vibration, stress.spin);
  nodes.push_back(static_cast<int>(largest_in(StressZone::body, zones, utilisation)));
  return nodes;
}

Eigen::MatrixXd stress_over_speed(const FieldsReader& reader, const Study& study, const std::vector<int>& nodes) {
  if (nodes.empty()) return {};
  const std::vector<SpeedResponse>& speeds = study.response.speeds;
  const NodeStress at_nodes(reader, nodes);
  std::vector<BlockedModes> modes;
  for (const int n : study.response.scene.nodal_diameters) {
    Eigen::MatrixXcd basis;
    modes.push_back(blocked_modes(study.model.nodal_diameters[static_cast<std::size_t>(n)], n,
                                  study.model.contact_dofs(), study.range.high, basis));
    modes.back().stress = at_nodes.of(n, basis);
  }
  const SpeedStress stress(study.response.scene, modes);
  const auto count = static_cast<Eigen::Index>(nodes.size());
  Eigen::MatrixXd largest(count, static_cast<Eigen::Index>(speeds.size()));
  work_on_pieces(largest.cols(), 1, 0, [&](Eigen::Index i, Eigen::Index) {
    stop_if_interrupted();
    largest.col(i) = stress.largest(speeds[static_cast<std::size_t>(i)], count);
  });
  return largest;
}

std::vector<std::size_t> speeds_between(const Study& study) {
  constexpr int most = 48;
  const std::vector<SpeedResponse>& speeds = study.response.speeds;
  std::set<std::size_t> chosen;
  for (int i = 0; i < most; ++i) {
    const double place = study.range.low + (study.range.high - study.range.low) * i / (most - 1);
    const auto nearest = std::ranges::min_element(
        speeds, {}, [&](const SpeedResponse& speed) { return std::abs(speed.speed - place); });
    if (nearest->snapshot) chosen.insert(static_cast<std::size_t>(nearest - speeds.begin()));
  }
  return {chosen.begin(), chosen.end()};
}

std::vector<int> nodes_between(const Study& study, const StressZones& zones,
                               const std::optional<MaterialStrength>& strength, const SectorStress& on_sector,
                               Progress& progress) {
  std::vector<SectorStress::At> instants;
  for (const std::size_t index : speeds_between(study)) {
    const SpeedResponse& response = study.response.speeds[index];
    instants.push_back({wheel_instant(response, study.response.scene), response.speed});
  }
  std::vector<int> all;
  on_sector.over(instants, progress, [&](std::size_t, const CycleStress& stress) {
    const std::vector<int> nodes = governing_nodes(stress, zones, strength);
    all.insert(all.end(), nodes.begin(), nodes.end());
  });
  return all;
}

EstimatedStress estimated_stress(const FieldsReader& reader, const Study& study, const std::vector<int>& nodes,
                                 const WaveField& spin, const std::optional<MaterialStrength>& strength) {
  const Eigen::MatrixXd stress = stress_over_speed(reader, study, nodes);
  EstimatedStress estimated;
  if (stress.size() == 0) return estimated;
  estimated.vibration = stress.colwise().maxCoeff();
  if (!strength) return estimated;
  const Eigen::VectorXd of_spin = von_mises(spin.stress.real())(nodes);
  estimated.utilisation.resize(stress.cols());
  for (Eigen::Index k = 0; k < stress.cols(); ++k) {
    const double share = std::pow(study.speed_at(k).speed / study.range.high, 2);
    estimated.utilisation[k] =
        goodman_utilisation<Eigen::VectorXd>(*strength, stress.col(k), share * of_spin).maxCoeff();
  }
  return estimated;
}

}  // namespace tiprub::postprocess
