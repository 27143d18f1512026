// SPDX-License-Identifier: GPL-3.0-or-later
#include "synthetic_scene.h"

#include <cmath>
#include <complex>
#include <fstream>
#include <numbers>

#include "cases/program/units.h"
#include "postprocess/waves/aliasing.h"
#include "reduce/model/reduced_model_file.h"
#include "simulate/motion/casing_areas.h"
#include "simulate/response/response_file.h"
#include "synthetic_fields.h"
#include "tests/simulate/written_response.h"

namespace tiprub::postprocess::synthetic {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr int contact_nodes = 4;
constexpr int steps_per_sample = 10;
constexpr int dofs = 3 * contact_nodes + 4;
constexpr double nodal_mass = 0.01;  // [kg]

/// A fixed orthogonal matrix that mixes the dofs.
Eigen::MatrixXd mixing() {
  Eigen::MatrixXd seed(dofs, dofs);
  for (int i = 0; i < dofs; ++i)
    for (int k = 0; k < dofs; ++k) seed(i, k) = std::sin(1.0 + 3.7 * i + 2.3 * k * k);
  return Eigen::HouseholderQR<Eigen::MatrixXd>(seed).householderQ();
}

ContactLine tip_line() {
  ContactLine line;
  line.position.resize(contact_nodes, 3);
  line.normal.resize(contact_nodes, 3);
  line.arc_length.resize(contact_nodes);
  line.static_shift.terms = {Eigen::MatrixX3d::Zero(contact_nodes, 3)};
  for (int k = 0; k < contact_nodes; ++k) {
    const double turn = 0.5 * std::numbers::pi * k / (contact_nodes - 1), radius = 0.04;
    line.position.row(k) << 0.1 - radius * std::cos(turn), 0.15 * k, radius * std::sin(turn);
    line.normal.row(k) << std::cos(turn), 0.0, -std::sin(turn);
    line.arc_length[k] = radius * turn;
  }
  return line;
}

double amplification(double ratio) {
  constexpr double damping = 0.004;
  return 1 / std::sqrt(std::pow(1 - ratio * ratio, 2) + std::pow(2 * damping * ratio, 2));
}

/// Forced response of the two families to one harmonic of the casing.
Wave driven_wave(int engine_order, int sectors, double speed) {
  const int n = signed_nodal_diameter(engine_order, sectors);
  const double forcing = engine_order * speed / two_pi, strength = 4e-5 / engine_order;
  double amplitude = 0;
  for (int family = 0; family < 2; ++family)
    amplitude +=
        strength * (family == 0 ? 1.0 : 0.6) * amplification(forcing / frequency(std::abs(n), family, speed));
  return {static_cast<double>(engine_order), n, 0.15 * amplitude + 2 * strength, 0.3 * engine_order};
}

/// A speed that settled, without motion and contact.
SpeedResponse motionless(const SimulatedScene& scene, const ContactLine& contact, double omega,
                         int recorded_revolutions) {
  constexpr int samples_per_revolution = 360, areas = 200;
  const int samples = samples_per_revolution * recorded_revolutions;
  const int points = scene.independent_sectors * contact.size();
  SpeedResponse response;
  response.speed = omega;
  response.clearance = scene.clearance;
  response.samples_per_revolution = samples_per_revolution;
  response.steps_per_revolution = samples_per_revolution * steps_per_sample;
  response.recorded_revolutions = recorded_revolutions;
  response.revolutions = 10 * recorded_revolutions;
  response.motion = MotionClass::periodic;
  response.period_revolutions = response.period_beats = 1;
  response.change = 3e-5;
  response.change_rate = 0.8;
  response.energy.closing_error = 2e-4;
  response.displacement.setZero(samples, 3 * points);
  response.contact_force.setZero(samples, points);
  response.contact_count.setZero(points, areas);
  return response;
}

/// Moves the contact nodes of a sector along their normals and lets the casing push; whether it does.
bool move_sector(SpeedResponse& response, const SimulatedScene& scene, const ContactLine& contact, int sample,
                 int sector, const Eigen::Vector4d& motion) {
  const double turned = two_pi * sample / response.samples_per_revolution;
  const double alpha = two_pi * sector / scene.sector_count;
  const auto areas = static_cast<int>(response.contact_count.cols());
  bool touching = false;
  for (int node = 0; node < contact.size(); ++node) {
    const int point = sector * contact.size() + node;
    response.displacement.block<1, 3>(sample, 3 * point) =
        motion[node] * (contact.normal.row(node) + 0.8 * Eigen::RowVector3d::UnitY());
    const double angle = std::fmod(alpha + contact.position(node, 1) + turned, two_pi);
    const double gap = scene.clearance[node] - 3e-4 * std::cos(2 * angle) - motion[node];
    if (gap >= 0) continue;
    touching = true;
    response.contact_force(sample, point) = -gap * 1e6;
    const CasingSteps way{contact.position(node, 1), sector, scene.sector_count, response.steps_per_revolution};
    for (int step = 0; step < steps_per_sample; ++step)
      ++response.contact_count(point, casing_area(way, sample * steps_per_sample + step, areas));
  }
  return touching;
}

}  // namespace

double rest_frequency(int nodal_diameter, int family) {
  if (family == 0) return 1500.0 + 12.0 * nodal_diameter;
  if (family == 1) return 2300.0 + 60.0 * nodal_diameter;
  return 4000.0 + 700.0 * family;
}

double frequency(int nodal_diameter, int family, double speed) {
  return std::hypot(rest_frequency(nodal_diameter, family), std::sqrt(stiffening) * speed / two_pi);
}

double crossing_speed(int nodal_diameter, int family, int engine_order) {
  return two_pi * rest_frequency(nodal_diameter, family) / std::sqrt(engine_order * engine_order - stiffening);
}

ReducedModel model(int sector_count) {
  ReducedModel model;
  model.sector_count = sector_count;
  model.speed_max = 2500;
  model.prestress = Prestress::given;
  model.contact = tip_line();
  model.provenance = "a made rotor";
  const Eigen::MatrixXd mix = mixing();
  for (int n = 0; n <= model.nodal_diameter_max(); ++n) {
    Eigen::VectorXd squares(dofs);
    for (int family = 0; family < dofs; ++family) squares[family] = std::pow(two_pi * rest_frequency(n, family), 2);
    NodalDiameterModel matrices;
    Eigen::MatrixXd stiffness = nodal_mass * mix * squares.asDiagonal() * mix.transpose();
    stiffness = 0.5 * (stiffness + stiffness.transpose()).eval();
    matrices.K.terms = {stiffness.cast<std::complex<double>>(),
                        stiffening * nodal_mass * Eigen::MatrixXcd::Identity(dofs, dofs)};
    matrices.M = nodal_mass * Eigen::MatrixXcd::Identity(dofs, dofs);
    model.nodal_diameters.push_back(matrices);
  }
  model.effects = effects_of(model);
  return model;
}

FrequencyTable frequencies(const ReducedModel& model) {
  constexpr int speeds = 33;
  FrequencyTable table;
  table.speed = Eigen::VectorXd::LinSpaced(speeds, 0.0, model.speed_max);
  for (const NodalDiameterModel& matrices : model.nodal_diameters) {
    Eigen::MatrixXd& curves = table.by_nodal_diameter.emplace_back(speeds, matrices.M.rows());
    for (int i = 0; i < speeds; ++i) curves.row(i) = matrices.natural_frequencies(table.speed[i]);
  }
  return table;
}

SimulatedScene two_lobes() {
  constexpr int points = 721;
  SimulatedScene scene;
  scene.sector_count = 10;
  scene.independent_sectors = 5;
  scene.nodal_diameters = {0, 2, 4};
  scene.casing_angle = Eigen::VectorXd::LinSpaced(points, 0.0, two_pi);
  scene.casing_distortion = (3e-4 * (2 * scene.casing_angle.array()).cos()).matrix();
  scene.lobes = 2;
  scene.damping.by_family = {0.004};
  scene.effects = {{Effect::friction, Treatment::left_out, "along the normal alone"},
                   {Effect::blade_clearance, Treatment::left_out, "all blades alike"},
                   {Effect::damping, Treatment::modelled, "a ratio for each mode"}};
  scene.clearance = Eigen::VectorXd::LinSpaced(contact_nodes, 3.2e-4, 2.6e-4);
  scene.clearance_state = ClearanceState::cold;
  scene.scope =
      "nodal diameters 0, 2, 4: the casing repeats twice around, the others stay at rest\n"
      "5 of 10 sectors: sector j moves as sector j + 5\nno friction, rigid casing, tuned wheel";
  scene.model_digest = digest(model());
  scene.provenance = "a made response";
  return scene;
}

SpeedResponse speed(const SimulatedScene& scene, const ContactLine& contact, double omega,
                    const std::vector<Wave>& waves, int recorded_revolutions) {
  SpeedResponse response = motionless(scene, contact, omega, recorded_revolutions);
  for (int sample = 0; sample < response.displacement.rows(); ++sample) {
    const double turned = two_pi * sample / response.samples_per_revolution;
    bool touching = false;
    for (int sector = 0; sector < scene.independent_sectors; ++sector) {
      const double alpha = two_pi * sector / scene.sector_count;
      Eigen::Vector4d motion = Eigen::Vector4d::Zero();
      for (const Wave& wave : waves)
        motion += wave.amplitude *
                  std::cos(wave.engine_order * turned + wave.signed_nodal_diameter * alpha + wave.phase) * wave.shape;
      touching = move_sector(response, scene, contact, sample, sector, motion) || touching;
    }
    response.contact_steps += touching ? steps_per_sample : 0;
  }
  return response;
}

Response resonant_sweep(const ReducedModel& rotor) {
  constexpr int count = 48;
  Response response;
  response.scene = two_lobes();
  response.key = "made";
  response.frequencies = frequencies(rotor);
  for (int i = 0; i < count; ++i) {
    const double omega = (10500.0 + 8000.0 * i / (count - 1)) * rad_s_per_rpm;
    std::vector<Wave> waves;
    for (int order = 2; order <= 12; order += 2) waves.push_back(driven_wave(order, rotor.sector_count, omega));
    if (i == 30) waves.push_back({4.5, 0, 3e-5, 0.0});
    if (i == 31) waves.push_back({5.25, 2, 2e-5, 0.0});
    SpeedResponse made = speed(response.scene, rotor.contact, omega, waves);
    if (i == 30) {
      made.motion = MotionClass::subharmonic;
      made.period_revolutions = 2;
      made.period_beats = 4;
    }
    if (i == 31) {
      made.motion = MotionClass::broadband;
      made.period_revolutions = made.period_beats = 0;
    }
    if (i == 40) {
      made = SpeedResponse{};
      made.speed = omega;
      made.failure = "the step is above the limit of central differences";
    }
    response.speeds.push_back(made);
  }
  return response;
}

void write_scene(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const ReducedModel rotor = model();
  write_model(rotor, folder / "model.h5", "test");
  Response response = resonant_sweep(rotor);
  add_snapshots(rotor, response);
  write_response(response, folder / "response.h5", "test");
  write_fields(rotor, folder / "fields.h5");
  std::ofstream(folder / "case.toml")
      << "title = \"A made wheel & an <oval> casing\"\n\n[postprocess]\nfamilies = 2\n";
}

}  // namespace tiprub::postprocess::synthetic
