// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/branches/orbit_family.h"

#include <cstdint>

#include "reduce/model/dense_eigen.h"
#include "simulate/march/time_march.h"
#include "simulate/orbits/recording.h"
#include "simulate/periodic/marched_map.h"

namespace tiprub::simulate {

namespace {

constexpr std::size_t most_kept = 4;  // speeds: a continuation step alternates between two

/// The unitary part of a matrix O, O (O^H O)^-1/2.
Eigen::MatrixXcd unitary_part(const Eigen::MatrixXcd& matrix) {
  const auto [squares, vectors] = eigenpairs(Eigen::MatrixXcd(matrix.adjoint() * matrix));
  return matrix * (vectors * squares.cwiseInverse().cwiseSqrt().asDiagonal() * vectors.adjoint());
}

}  // namespace

/// The march at one speed and the rotation of its modes onto those of the reference speed.
class OrbitFamily::MapAtSpeed final : public PeriodicMap {
 public:
  MapAtSpeed(const Scene& scene, const RotorAtSpeed& reference, double speed, int steps_per_revolution)
      : scene_(scene),
        march_(marched_scene(scene, rotor_of(scene, speed, OtherDiameters::unknown), steps_per_revolution)),
        map_(march_),
        layout_(unpadded(reference)),
        ratio_(reference.speed / speed) {
    march_.set_step(scene.casing.grown_after() * steps_per_revolution);
    for (std::size_t i = 0; i < march_.rotor().waves.size(); ++i) {
      const WaveModes &wave = march_.rotor().waves[i], &fixed = reference.waves[i];
      const Eigen::MatrixXcd& M = scene.model.nodal_diameters[static_cast<std::size_t>(wave.nodal_diameter)].M;
      const Eigen::Index moving = wave.moving;
      turns_.push_back({unitary_part(fixed.shapes.leftCols(moving).adjoint() * M * wave.shapes.leftCols(moving)),
                        wave.omega.head(moving).max(speed), fixed.omega.head(moving).max(reference.speed)});
    }
  }

  MapImage image(const Eigen::VectorXd& state) override {
    MapImage image = map_.image(of_march(state));
    image.state = of_family(image.state);
    return image;
  }
  Eigen::VectorXd tangent(const std::shared_ptr<const ContactPattern>& pattern,
                          const Eigen::VectorXd& change) override {
    return of_family(map_.tangent(pattern, of_march(change)));
  }
  Eigen::VectorXd precondition(const Eigen::VectorXd& change) override {
    return of_family(map_.precondition(of_march(change)));
  }
  Eigen::VectorXd seed() const override { return of_family(map_.seed()); }

  Eigen::VectorXd of_family(const Eigen::VectorXd& state) const {
    Eigen::VectorXd turned(layout_.size());
    for (std::size_t i = 0; i < turns_.size(); ++i) {
      const auto& [unitary, scale, fixed_scale] = turns_[i];
      auto [position, velocity] = map_.symmetric().layout().read(state, i);
      position.conservativeResize(scale.size());
      velocity.conservativeResize(scale.size());
      position.array() /= scale;
      position = (unitary * position).eval();
      position.array() *= fixed_scale;
      velocity = (unitary * velocity).eval() * ratio_;
      layout_.write({position, velocity}, i, turned);
    }
    return turned;
  }
  Eigen::VectorXd of_march(const Eigen::VectorXd& state) const {
    const StateLayout& padded = map_.symmetric().layout();
    Eigen::VectorXd turned(padded.size());
    for (std::size_t i = 0; i < turns_.size(); ++i) {
      const auto& [unitary, scale, fixed_scale] = turns_[i];
      auto [position, velocity] = layout_.read(state, i);
      position.array() /= fixed_scale;
      position = (unitary.adjoint() * position).eval();
      position.array() *= scale;
      velocity = (unitary.adjoint() * velocity).eval() / ratio_;
      position.conservativeResizeLike(Eigen::VectorXcd::Zero(march_.wave(i).moving));
      velocity.conservativeResizeLike(Eigen::VectorXcd::Zero(march_.wave(i).moving));
      padded.write({position, velocity}, i, turned);
    }
    return turned;
  }

  double amplitude(const Eigen::VectorXd& state) {
    const std::int64_t start = march_.step_count();
    map_.put(of_march(state));
    const int samples = scene_.scope.samples_per_revolution;
    Recording recording(march_, {samples, 1, 1, 1.0, 1.0});
    recording.revolution();
    march_.set_step(start);
    return recording.finish().amplitude;
  }

 private:
  struct Turn {
    Eigen::MatrixXcd unitary;
    Eigen::ArrayXd scale, fixed_scale;  ///< [rad/s] of positions, here and at the reference speed
  };

  /// Leaves out the modes that the march adds as padding.
  static StateLayout unpadded(const RotorAtSpeed& rotor) {
    std::vector<StateLayout::Wave> waves;
    for (const WaveModes& wave : rotor.waves)
      waves.push_back({wave.moving, wave.kind == WaveKind::travelling ? 2 : 1});
    return StateLayout(std::move(waves));
  }

  const Scene& scene_;
  TimeMarch march_;
  MarchedMap map_;
  StateLayout layout_;  ///< of the family's states
  double ratio_;        ///< [1] of the reference speed to this one
  std::vector<Turn> turns_;
};

OrbitFamily::OrbitFamily(const Scene& scene, double reference_speed, int steps_per_revolution)
    : scene_(scene),
      reference_(rotor_of(scene, reference_speed, OtherDiameters::unknown)),
      steps_per_revolution_(steps_per_revolution) {}

std::shared_ptr<OrbitFamily::MapAtSpeed> OrbitFamily::map(double speed) {
  for (const auto& [known, map] : kept_)
    if (known == speed) return map;
  kept_.emplace_front(speed, std::make_shared<MapAtSpeed>(scene_, *reference_, speed, steps_per_revolution_));
  if (kept_.size() > most_kept) kept_.pop_back();
  return kept_.front().second;
}

std::shared_ptr<PeriodicMap> OrbitFamily::at(double speed) {
  return map(speed);
}

double OrbitFamily::amplitude(double speed, const Eigen::VectorXd& state) {
  return map(speed)->amplitude(state);
}

double OrbitFamily::maps_per_revolution() const {
  return symmetric_maps_per_revolution(scene_.model.sector_count, scene_.casing.lobes);
}

Eigen::VectorXd OrbitFamily::of_family(double speed, const Eigen::VectorXd& state) {
  return map(speed)->of_family(state);
}

Eigen::VectorXd OrbitFamily::of_march(double speed, const Eigen::VectorXd& state) {
  return map(speed)->of_march(state);
}

}  // namespace tiprub::simulate
