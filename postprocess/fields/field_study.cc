// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/field_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <utility>

#include "cases/program/errors.h"
#include "cases/program/signal_cleanup.h"
#include "postprocess/fields/node_stress.h"
#include "postprocess/fields/sector_stress.h"
#include "postprocess/tables/table.h"
#include "reduce/model/reduced_model.h"

namespace tiprub::postprocess {

namespace {

constexpr double same_place = 1e-6;        // of the largest radius
constexpr double near_segment = 0.2;       // of it; its nodes surround a segment's centre
constexpr double left_out_waves = 0.002;   // [1] of the mean square of a motion
constexpr std::size_t most_waves = 6;      // of a motion, that are recovered
constexpr std::size_t waves_at_once = 24;  // of a nodal diameter; more would take much memory on large sectors
constexpr double much_stressed = 0.3;      // of the largest stress at a critical speed
constexpr double most_stressed = 0.5;      // of it: with more nodes, those of a finer mesh would not fit into memory
constexpr double m_per_mm = 1e-3;
constexpr double largest_radius = 1e3;  // [m] of any wheel
constexpr double unit_error = 1e-3;     // of the motion of a contact node, which is exact to single precision
constexpr double tip_motion = 30;  // a tip moves by no more, and by no less than 1/30, of the mean over a segment

/// Checks that the basis moves the contact nodes as the contact dofs of the model say, which a basis in another unit
/// does not.
void check_contact_shapes(const FieldsReader& reader, const ReducedModel& model, int n, const std::string& name) {
  const std::vector<int>& contact = reader.sector().node_set("contact");
  for (int dof = 0; dof < model.contact_dofs(); ++dof) {
    const Eigen::VectorXcd shape = reader.shape(n, dof);
    Eigen::VectorXcd moved(contact.size());
    for (std::size_t k = 0; k < contact.size(); ++k)
      moved[static_cast<Eigen::Index>(k)] = shape[3 * contact[k] + dof % 3];
    const double largest = moved.cwiseAbs().maxCoeff();
    moved[dof / 3] -= 1.0;
    if (model.contact.kind == ContactKind::points ? moved.cwiseAbs().maxCoeff() <= unit_error
                                                  : largest <= tip_motion && largest >= 1 / tip_motion)
      continue;
    throw InputError(name + ": /nodal_diameter/" + std::to_string(n) + "/basis moves the contact nodes by up to " +
                     significant(largest, 3) + " m for 1 m of contact dof " + std::to_string(dof) +
                     "; give the fields that were written with the model");
  }
}

void check_together(const FieldsReader& reader, const ReducedModel& model, const std::string& name) {
  const SectorFields& sector = reader.sector();
  const auto refuse = [&](const std::string& what) {
    throw InputError(name + ": " + what + "; give the fields that were written with the model");
  };
  if (sector.sector_count != model.sector_count)
    refuse("has " + std::to_string(sector.sector_count) + " sectors, the model has " +
           std::to_string(model.sector_count));
  if (reader.model_digest() != digest(model)) refuse("was written with another model of the same size");
  const std::vector<int>& contact = sector.node_set("contact");
  if (static_cast<int>(contact.size()) != model.contact.size())
    refuse("has " + std::to_string(contact.size()) + " contact nodes, the model has " +
           std::to_string(model.contact.size()));
  const double radius = outer_radius(sector);
  if (!(radius < largest_radius))
    throw InputError(name + ": /nodes: the sector reaches beyond " + significant(largest_radius, 1) + " m");
  const double reach = (model.contact.kind == ContactKind::points ? same_place : near_segment) * radius;
  for (std::size_t k = 0; k < contact.size(); ++k) {
    const Eigen::RowVector3d place = model.contact.position.row(static_cast<Eigen::Index>(k));
    const Eigen::Vector3d there(place[0] * std::cos(place[1]), place[0] * std::sin(place[1]), place[2]);
    if ((sector.nodes.col(contact[k]) - there).norm() > reach)
      refuse("contact node " + std::to_string(k) + " is elsewhere than the model's");
  }
  for (int n = 0; n <= model.nodal_diameter_max(); ++n) {
    if (reader.dofs(n) != model.nodal_diameters[static_cast<std::size_t>(n)].M.rows())
      refuse("has " + std::to_string(reader.dofs(n)) + " dofs at nodal diameter " + std::to_string(n) +
             ", the model has " + std::to_string(model.nodal_diameters[static_cast<std::size_t>(n)].M.rows()));
    check_contact_shapes(reader, model, n, name);
  }
}

/// Speeds whose fields are recovered: the critical ones, or the one with the largest amplitude if there is none.
std::vector<std::size_t> recovered_speeds(const std::vector<CriticalSpeed>& all, const TipAmplitudes& amplitudes) {
  std::vector<std::size_t> speeds;
  for (const CriticalSpeed& critical : all) speeds.push_back(static_cast<std::size_t>(critical.index));
  if (speeds.empty()) speeds.push_back(static_cast<std::size_t>(amplitudes.worst()));
  return speeds;
}

using VariedCycles = std::vector<std::optional<WheelCycle>>;

/// Of the speeds whose states the response holds.
struct RecoveredCycles {
  std::vector<std::size_t> index;    ///< of each speed
  std::vector<SectorStress::At> at;  ///< as `index`
  std::vector<VariedCycles>
      varied;  ///< as `index`: of each peak in SpeedResponse::budget that has a cycle of this model
};

VariedCycles varied_cycles(const std::vector<PeakVariation>& budget, const SimulatedScene& scene,
                           const ReducedModel& model) {
  VariedCycles cycles;
  for (const PeakVariation& peak : budget)
    cycles.push_back(peak.cycle && peak.model_digest.empty() ? std::optional(wheel_cycle(peak, scene, model))
                                                             : std::nullopt);
  return cycles;
}

RecoveredCycles cycles_at(const std::vector<std::size_t>& speeds, const Response& all, const ReducedModel& model) {
  RecoveredCycles cycles;
  for (const std::size_t index : speeds) {
    const SpeedResponse& response = all.speeds[index];
    if (!response.cycle && !response.snapshot) continue;
    cycles.index.push_back(index);
    cycles.at.push_back({wheel_cycle(response, all.scene, model), response.speed});
    cycles.varied.push_back(varied_cycles(response.budget, all.scene, model));
  }
  return cycles;
}

std::size_t samples_of(const RecoveredCycles& cycles) {
  std::size_t samples = 0;
  for (const SectorStress::At& at : cycles.at) samples += static_cast<std::size_t>(samples_on_sector(at.cycle));
  for (const VariedCycles& of_speed : cycles.varied)
    for (const auto& varied : of_speed) samples += varied ? static_cast<std::size_t>(varied->samples()) : 0;
  return samples;
}

std::size_t worst_of(const std::vector<std::size_t>& speeds, const Eigen::VectorXd& amplitudes) {
  return *std::ranges::max_element(speeds, {},
                                   [&](std::size_t index) { return amplitudes[static_cast<Eigen::Index>(index)]; });
}

/// Recovers the displacement of all waves, which takes their states. Several of a nodal diameter are read together.
void recover_waves(const FieldsReader& reader, std::vector<MovingWheel>& wheels) {
  struct Wave {
    RotorWave& in_model;
    WaveField& on_sector;
  };
  std::map<int, std::vector<Wave>> by_nodal_diameter;
  for (MovingWheel& wheel : wheels) {
    wheel.waves.resize(wheel.motion.waves.size());
    for (std::size_t i = 0; i < wheel.waves.size(); ++i)
      by_nodal_diameter[wheel.motion.waves[i].nodal_diameter].push_back({wheel.motion.waves[i], wheel.waves[i]});
  }
  for (auto& [n, waves] : by_nodal_diameter)
    for (std::size_t first = 0; first < waves.size(); first += waves_at_once) {
      stop_if_interrupted();
      const auto count = static_cast<Eigen::Index>(std::min(waves_at_once, waves.size() - first));
      const std::span<Wave> some = std::span(waves).subspan(first, static_cast<std::size_t>(count));
      Eigen::MatrixXcd states(reader.dofs(n), count);
      Eigen::Index column = 0;
      for (Wave& wave : some) states.col(column++) = std::exchange(wave.in_model.state, {});
      const Eigen::MatrixXcd found = reader.expand(n, states);
      column = 0;
      for (Wave& wave : some) wave.on_sector = {n, cartesian(reader.sector(), found.col(column++)), {}};
    }
}

/// Sector, zones, and the modes at a speed.
FieldStudy without_motion(const FieldsReader& reader, const Study& study, double speed) {
  FieldStudy fields;
  fields.sector = reader.sector();
  fields.mesh_error_of_frequencies = reader.cell_errors_of_frequencies();
  fields.mesh_error_of_compliances = reader.cell_errors_of_compliances();
  fields.zones = stress_zones(fields.sector, m_per_mm * study.parameters.tip_patch_mm);
  fields.speed = speed;
  fields.modes = natural_modes(reader, study.model, study.response.scene.lobes, study.parameters.families, speed);
  return fields;
}

/// [Pa] The stress at the varied peaks that have a cycle, by critical speed, at some nodes.
std::vector<std::vector<std::optional<double>>> varied_stress(const FieldsReader& reader,
                                                              const std::vector<int>& nodal_diameters,
                                                              const std::set<int>& nodes,
                                                              const std::vector<VariedCycles>& cycles,
                                                              Progress& progress) {
  const NodeStress at_nodes(reader, {nodes.begin(), nodes.end()});
  LargestStress largest;  // made for the first cycle
  std::vector<std::vector<std::optional<double>>> all;
  for (const VariedCycles& varied : cycles) {
    std::vector<std::optional<double>>& of_peak = all.emplace_back(varied.size());
    for (std::size_t i = 0; i < varied.size(); ++i) {
      stop_if_interrupted();
      if (!varied[i]) continue;
      if (!largest) largest = largest_stress(at_nodes, reader, nodal_diameters);
      of_peak[i] = largest(*varied[i]);
      for (int s = 0; s < varied[i]->samples(); ++s) progress.advance();
    }
  }
  return all;
}

/// Adds the stress at the varied peaks of another model, near nodes of the sector.
void add_stress_of_other_model(const FieldsReader& other, const Response& response,
                               const std::vector<std::size_t>& speeds, const std::vector<int>& nodes,
                               FieldStudy& fields) {
  LargestStress largest;  // made for the first cycle
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    const std::vector<PeakVariation>& budget = response.speeds[speeds[k]].budget;
    for (std::size_t i = 0; i < budget.size(); ++i) {
      stop_if_interrupted();
      if (!budget[i].cycle || budget[i].model_digest.empty()) continue;
      if (!largest) largest = stress_of_other_model(other, fields.sector, nodes, fields.zones, response.scene);
      fields.varied[k][i] = largest(whole_cycle(*budget[i].cycle, response.scene));
    }
  }
}

/// A peak with its speed and the samples of its cycle.
FieldPeak dated(FieldPeak peak, const WheelCycle& cycle, double speed) {
  peak.speed = speed;
  peak.samples = cycle.whole ? cycle.recorded_samples : 0;
  return peak;
}

void add(const std::vector<int>& nodes, std::set<int>& to) {
  to.insert(nodes.begin(), nodes.end());
}

/// Nodes of the body at which more is computed than the stress of the recovered cycles.
struct WatchedNodes {
  std::set<int> stressed;    ///< over speed
  std::set<int> much, most;  ///< where the budgets' peaks stress this model, and another one

  void add_those_of(const CycleStress& stress, const StressZones& zones,
                    const std::optional<MaterialStrength>& strength) {
    add(stressed_nodes(stress, zones), stressed);
    add(governing_nodes(stress, zones, strength), stressed);
    add(nodes_above(much_stressed, stress, zones), much);
    add(nodes_above(most_stressed, stress, zones), most);
  }
};

/// The whole wheel at the snapshot of a speed.
void recover_instant(const SpeedResponse& response, const SectorStress& sector, const WaveField& spin,
                     FieldStudy& fields) {
  const RotorSnapshot& snapshot = *response.snapshot;
  const int count = fields.sector.sector_count;
  std::vector<WaveField> waves;
  for (std::size_t i = 0; i < snapshot.displacement.size(); ++i)
    waves.push_back(std::move(sector.recover(i, snapshot.displacement[i]).front()));
  fields.vibration = on_wheel(waves, count);
  fields.spin = on_wheel({spin}, count);
  fields.has_instant = true;
  fields.angle = 2 * std::numbers::pi * snapshot.sample / response.samples_per_revolution;
  fields.force = snapshot.force;
}

std::string scope_of(const std::optional<FieldStudy>& fields) {
  const std::string what = "displacement and stress on the whole wheel: ";
  if (!fields) return what + "left out, no fields.h5 was given (--fields)";
  const auto is_cycle = [](const FieldPeak& peak) { return peak.cycle.has_value(); };
  if (std::ranges::any_of(fields->peaks, is_cycle))
    return what + "over all recorded samples of the critical speeds, by linear elasticity";
  return what + (fields->has_instant ? "at the sample with the largest contact force, by linear elasticity; the "
                                       "response holds no whole cycle"
                                     : "modes only, the response holds no state of the rotor; simulate it again");
}

}  // namespace

void check_fields(const FieldsReader& reader, const ReducedModel& model) {
  check_together(reader, model, reader.path());
  sound_cells(reader);
}

FieldStudy recover_fields(const FieldsReader& reader, const FieldsReader* other, const Study& study,
                          const std::optional<MaterialStrength>& strength, Progress::Shown shown) {
  const CellStress bricks = sound_cells(reader);
  const std::vector<std::size_t> speeds = recovered_speeds(study.critical, study.amplitudes);
  const std::size_t worst = worst_of(speeds, study.amplitudes.largest);
  FieldStudy fields = without_motion(reader, study, study.response.speeds[worst].speed);
  const BladePlaces places(fields.sector);
  const SectorStress on_sector(reader, bricks, study.model, study.response.scene.nodal_diameters, fields.zones,
                               strength);
  const RecoveredCycles cycles = cycles_at(speeds, study.response, study.model);
  Progress progress("stress over cycles, by samples", samples_of(cycles) + speeds_between(study).size(), shown);
  WatchedNodes nodes;
  add(nodes_between(study, fields.zones, strength, on_sector, progress), nodes.stressed);
  // The varied cycles follow, at nodes that are known then.
  on_sector.over(cycles.at, progress, [&](std::size_t k, const CycleStress& stress) {
    const SpeedResponse& response = study.response.speeds[cycles.index[k]];
    fields.peaks.push_back(
        dated(field_peak(fields.sector, stress, fields.zones, places, strength), cycles.at[k].cycle, response.speed));
    nodes.add_those_of(stress, fields.zones, strength);
    if (response.cycle)
      fields.moving.push_back({response.speed,
                               wheel_motion(response, study.response.scene, study.model, left_out_waves, most_waves),
                               {},
                               stress});
    if (cycles.index[k] == worst && response.snapshot)
      recover_instant(response, on_sector, spin_field(fields.sector, bricks, response.speed), fields);
  });
  recover_waves(reader, fields.moving);
  fields.varied = varied_stress(reader, study.response.scene.nodal_diameters, nodes.much, cycles.varied, progress);
  if (other != nullptr)
    add_stress_of_other_model(*other, study.response, cycles.index, {nodes.most.begin(), nodes.most.end()}, fields);
  fields.estimated = estimated_stress(reader, study, {nodes.stressed.begin(), nodes.stressed.end()},
                                      spin_field(fields.sector, bricks, study.range.high), strength);
  return fields;
}

bool FieldResults::has_stress() const {
  return std::ranges::any_of(peaks, [](const auto& peak) { return peak.has_value(); });
}

bool FieldResults::has_cycles() const {
  return std::ranges::any_of(peaks, [](const auto& peak) { return peak && peak->cycle; });
}

const StressCycle* FieldResults::worst_cycle() const {
  const StressCycle* worst = nullptr;
  const auto look_at = [&](const std::optional<FieldPeak>& peak) {
    if (peak && peak->cycle && peak->cycle->goodman && (worst == nullptr || *peak->cycle->goodman > *worst->goodman))
      worst = &*peak->cycle;
  };
  for (const std::optional<FieldPeak>& peak : peaks) look_at(peak);
  look_at(of_no_critical);
  return worst;
}

FieldResults field_results(const std::optional<FieldStudy>& fields, const std::vector<CriticalSpeed>& critical) {
  FieldResults results{scope_of(fields), std::vector<std::optional<FieldPeak>>(critical.size())};
  results.varied.resize(critical.size());
  if (!fields) return results;
  results.zone_width = fields->zones.width;
  results.over_speed = fields->estimated.vibration;
  results.utilisation = fields->estimated.utilisation;
  if (critical.empty() && !fields->peaks.empty()) results.of_no_critical = fields->peaks.front();
  for (std::size_t i = 0; i < critical.size(); ++i)
    for (std::size_t k = 0; k < fields->peaks.size(); ++k) {
      if (fields->peaks[k].speed != critical[i].speed) continue;
      results.peaks[i] = fields->peaks[k];
      results.varied[i] = fields->varied[k];
    }
  return results;
}

Eigen::VectorXd utilisation_over_speed(const Study& study, const FieldResults& fields) {
  Eigen::VectorXd utilisation = fields.utilisation;
  if (utilisation.size() == 0) return utilisation;
  const auto take = [&](const std::optional<FieldPeak>& peak, Eigen::Index index) {
    if (peak && peak->cycle && peak->cycle->goodman) utilisation[index] = *peak->cycle->goodman;
  };
  for (std::size_t i = 0; i < study.critical.size(); ++i) take(fields.peaks[i], study.critical[i].index);
  take(fields.of_no_critical, study.amplitudes.worst());
  return utilisation;
}

std::optional<std::size_t> worst_critical(const Study& study, const FieldResults& fields) {
  const Eigen::VectorXd utilisation = utilisation_over_speed(study, fields);
  const auto severity = [&](std::size_t i) {
    const CriticalSpeed& peak = study.critical[i];
    return std::array{utilisation.size() > 0 ? utilisation[peak.index] : 0.0,
                      fields.peaks[i] ? fields.peaks[i]->body.vibration : 0.0, peak.amplitude};
  };
  std::optional<std::size_t> worst;
  for (std::size_t i = 0; i < study.critical.size(); ++i)
    if (!worst || severity(i) > severity(*worst)) worst = i;
  return worst;
}

}  // namespace tiprub::postprocess
