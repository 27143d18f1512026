// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/field_study.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "cases/program/errors.h"
#include "postprocess/tables/interruption.h"
#include "postprocess/waves/aliasing.h"

namespace tiprub {

namespace {

constexpr double same_place = 1e-6;      // of the largest radius
constexpr int mode_nodal_diameters = 3;  // drawn
constexpr int mode_families = 2;         // drawn

void check_together(const FieldsReader& reader, const ReducedModel& model, const std::string& name) {
  const SectorFields& sector = reader.sector();
  const auto refuse = [&](const std::string& what) {
    throw InputError(name + ": " + what + "; give the fields that were written with the model");
  };
  if (sector.sector_count != model.sector_count)
    refuse("has " + std::to_string(sector.sector_count) + " sectors, the model has " +
           std::to_string(model.sector_count));
  const std::vector<int>& contact = sector.node_set("contact");
  if (static_cast<int>(contact.size()) != model.contact.size())
    refuse("has " + std::to_string(contact.size()) + " contact nodes, the model has " +
           std::to_string(model.contact.size()));
  const double radius = outer_radius(sector);
  for (std::size_t k = 0; k < contact.size(); ++k) {
    const Eigen::RowVector3d place = model.contact.position.row(static_cast<Eigen::Index>(k));
    const Eigen::Vector3d there(place[0] * std::cos(place[1]), place[0] * std::sin(place[1]), place[2]);
    if ((sector.nodes.col(contact[k]) - there).norm() > same_place * radius)
      refuse("contact node " + std::to_string(k) + " is elsewhere than the model's");
  }
  for (int n = 0; n <= model.nodal_diameter_max(); ++n)
    if (reader.dofs(n) != model.nodal_diameters[static_cast<std::size_t>(n)].M.rows())
      refuse("has " + std::to_string(reader.dofs(n)) + " dofs at nodal diameter " + std::to_string(n) +
             ", the model has " + std::to_string(model.nodal_diameters[static_cast<std::size_t>(n)].M.rows()));
}

/// Those that the casing's first harmonics drive (eq. 17), ascending.
std::vector<int> drawn_nodal_diameters(const Study& study) {
  std::set<int> chosen;
  const int lobes = std::max(1, study.response.scene.lobes);
  for (int k = 1; k <= study.model.sector_count && chosen.size() < mode_nodal_diameters; ++k)
    chosen.insert(aliased_nodal_diameter(k * lobes, study.model.sector_count));
  return {chosen.begin(), chosen.end()};
}

/// Speeds whose fields are recovered: the critical ones, or the one with the largest amplitude if there is none.
std::vector<std::size_t> recovered_speeds(const Study& study) {
  std::vector<std::size_t> speeds;
  for (const CriticalSpeed& critical : study.critical) speeds.push_back(static_cast<std::size_t>(critical.index));
  if (speeds.empty()) speeds.push_back(static_cast<std::size_t>(study.worst));
  return speeds;
}

std::size_t worst_of(const std::vector<std::size_t>& speeds, const Study& study) {
  return *std::max_element(speeds.begin(), speeds.end(), [&](std::size_t a, std::size_t b) {
    return study.amplitudes.largest[static_cast<Eigen::Index>(a)] <
           study.amplitudes.largest[static_cast<Eigen::Index>(b)];
  });
}

struct Modes {
  Eigen::VectorXd frequency;  ///< [Hz]
  Eigen::MatrixXcd shapes;    ///< model dofs x families
};

Modes modes_of(const NodalDiameterModel& model, double speed, int families) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXcd> solver(model.stiffness(speed), model.M);
  const Eigen::Index count = std::min<Eigen::Index>(families, model.M.rows());
  return {solver.eigenvalues().head(count).cwiseMax(0.0).cwiseSqrt() / (2 * std::numbers::pi),
          solver.eigenvectors().leftCols(count)};
}

/// A mode has any size and any phase: its largest component becomes 1.
void normalise(Eigen::Matrix3Xcd& shape) {
  Eigen::Index row = 0, column = 0;
  shape.cwiseAbs().maxCoeff(&row, &column);
  shape /= shape(row, column);
}

Eigen::MatrixXd forces_at(const SpeedResponse& response, const SimulatedScene& scene, int nodes, int sample) {
  Eigen::MatrixXd forces(scene.sector_count, nodes);
  for (Eigen::Index j = 0; j < scene.sector_count; ++j)
    forces.row(j) = response.contact_force.row(sample).segment((j % scene.independent_sectors) * nodes, nodes);
  return forces;
}

/// Waves of several states at once: fields.h5 is large, and is read once a nodal diameter.
class Recovery {
 public:
  Recovery(const FieldsReader& reader, const Study& study) : reader_(reader), study_(study) {}

  void ask_modes(const std::vector<int>& nodal_diameters, double speed) {
    const int families = std::min(mode_families, study_.parameters.families);
    for (const int n : nodal_diameters)
      modes_[n] = modes_of(study_.model.nodal_diameters[static_cast<std::size_t>(n)], speed, families);
  }
  void ask_instants(const std::vector<std::size_t>& speeds) {
    for (const std::size_t speed : speeds)
      if (study_.response.speeds[speed].snapshot) instants_.push_back(speed);
    waves_.resize(instants_.size());
  }
  void run(const BrickStress& bricks, FieldStudy& fields) {
    const std::vector<int>& moving = study_.response.scene.nodal_diameters;
    for (int n = 0; n <= study_.model.nodal_diameter_max(); ++n) {
      stop_if_interrupted();
      const auto place = std::find(moving.begin(), moving.end(), n);
      const bool moves = place != moving.end() && !instants_.empty();
      if (!moves && !modes_.contains(n)) continue;
      recover(n, moves ? static_cast<std::size_t>(place - moving.begin()) : moving.size(), bricks, fields);
    }
  }
  const std::vector<std::size_t>& instants() const { return instants_; }
  const std::vector<WaveField>& waves(std::size_t instant) const { return waves_[instant]; }

 private:
  void recover(int n, std::size_t moving, const BrickStress& bricks, FieldStudy& fields) {
    const Eigen::MatrixXcd shapes = modes_.contains(n) ? modes_[n].shapes : Eigen::MatrixXcd();
    const Eigen::Index modes = shapes.cols();
    const bool moves = moving < study_.response.scene.nodal_diameters.size();
    Eigen::MatrixXcd asked(reader_.dofs(n), modes + (moves ? static_cast<Eigen::Index>(instants_.size()) : 0));
    if (modes > 0) asked.leftCols(modes) = shapes;
    for (Eigen::Index i = modes; i < asked.cols(); ++i)
      asked.col(i) = state(instants_[static_cast<std::size_t>(i - modes)], moving, asked.rows());
    const Eigen::MatrixXcd found = reader_.expand(n, asked);
    for (Eigen::Index i = 0; i < found.cols(); ++i) {
      WaveField wave{n, cartesian(reader_.sector(), found.col(i)), {}};
      if (i < modes) {
        normalise(wave.displacement);
        fields.modes.push_back({static_cast<int>(i), modes_[n].frequency[i], std::move(wave)});
      } else {
        add_stress(reader_.sector(), bricks, wave);
        waves_[static_cast<std::size_t>(i - modes)].push_back(std::move(wave));
      }
    }
  }
  Eigen::VectorXcd state(std::size_t speed, std::size_t moving, Eigen::Index dofs) const {
    const Eigen::VectorXcd& x = study_.response.speeds[speed].snapshot->displacement[moving];
    if (x.size() != dofs)
      throw InputError("the response's snapshot has " + std::to_string(x.size()) + " dofs, the model has " +
                       std::to_string(dofs) + "; give the model that the response was made with");
    return x;
  }

  const FieldsReader& reader_;
  const Study& study_;
  std::map<int, Modes> modes_;
  std::vector<std::size_t> instants_;
  std::vector<std::vector<WaveField>> waves_;  // by instant
};

}  // namespace

void check_fields(const std::filesystem::path& fields_file, const ReducedModel& model) {
  check_together(FieldsReader(fields_file), model, fields_file.string());
}

FieldStudy recover_fields(const std::filesystem::path& fields_file, const Study& study) {
  const FieldsReader reader(fields_file);
  check_together(reader, study.model, fields_file.string());
  FieldStudy fields;
  fields.sector = reader.sector();
  const BrickStress bricks(fields.sector);
  const std::vector<std::size_t> speeds = recovered_speeds(study);
  const std::size_t worst = worst_of(speeds, study);
  fields.speed = study.response.speeds[worst].speed;
  Recovery recovery(reader, study);
  recovery.ask_modes(drawn_nodal_diameters(study), fields.speed);
  recovery.ask_instants(speeds);
  recovery.run(bricks, fields);
  for (std::size_t i = 0; i < recovery.instants().size(); ++i) {
    const SpeedResponse& response = study.response.speeds[recovery.instants()[i]];
    const int count = fields.sector.sector_count;
    WheelField vibration = on_wheel(recovery.waves(i), count);
    WheelField spin = on_wheel({spin_field(fields.sector, bricks, response.speed)}, count);
    fields.peaks.push_back(field_peak(fields.sector, response.speed, vibration, spin));
    if (recovery.instants()[i] != worst) continue;
    fields.has_instant = true;
    fields.angle = 2 * std::numbers::pi * response.snapshot->sample / response.samples_per_revolution;
    fields.force = response.snapshot->force;
    fields.contact_force =
        forces_at(response, study.response.scene, study.model.contact.size(), response.snapshot->sample);
    fields.invariant_sectors = count / std::gcd(count, study.response.scene.lobes);
    fields.invariance = turn_difference(vibration, fields.invariant_sectors);
    fields.vibration = std::move(vibration);
    fields.spin = std::move(spin);
  }
  return fields;
}

}  // namespace tiprub
