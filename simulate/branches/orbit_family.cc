// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/branches/orbit_family.h"

#include <cmath>
#include <cstdint>
#include <numeric>

#include "reduce/model/dense_eigen.h"
#include "simulate/march/time_march.h"
#include "simulate/orbits/recording.h"
#include "simulate/periodic/marched_map.h"

namespace tiprub {

namespace {

constexpr std::size_t most_kept = 4;  // speeds: a step of continuation goes to and fro between two

/// The unitary part of a matrix O, O (O^H O)^-1/2.
Eigen::MatrixXcd unitary_part(const Eigen::MatrixXcd& matrix) {
  const auto [squares, vectors] = eigenpairs(Eigen::MatrixXcd(matrix.adjoint() * matrix));
  return matrix * (vectors * squares.cwiseInverse().cwiseSqrt().asDiagonal() * vectors.adjoint());
}

}  // namespace

/// One speed's march, and how its modes stand to those of the reference speed.
class OrbitFamily::MapAtSpeed final : public PeriodicMap {
 public:
  MapAtSpeed(const Scene& scene, const RotorAtSpeed& reference, double speed, int steps_per_revolution)
      : scene_(scene),
        march_(marched_scene(scene, rotor_of(scene, speed, OtherDiameters::unknown), steps_per_revolution)),
        map_(march_),
        ratio_(reference.speed / speed) {
    march_.set_step(grown_steps());
    for (std::size_t i = 0; i < march_.rotor().waves.size(); ++i) {
      const WaveModes &wave = march_.rotor().waves[i], &fixed = reference.waves[i];
      const Eigen::MatrixXcd& M = scene.model.nodal_diameters[static_cast<std::size_t>(wave.nodal_diameter)].M;
      const Eigen::Index moving = wave.moving;
      turns_.push_back({unitary_part(fixed.shapes.leftCols(moving).adjoint() * M * wave.shapes.leftCols(moving)),
                        wave.omega.head(moving).max(speed), fixed.omega.head(moving).max(reference.speed),
                        march_.wave(i).moving, wave.kind == WaveKind::travelling ? 2 : 1});
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

  Eigen::VectorXd of_family(const Eigen::VectorXd& state) const {
    Eigen::VectorXd turned(size());
    Eigen::Index from = 0, to = 0;
    for (const Turn& turn : turns_)
      for (const bool is_position : {true, false}) {
        Eigen::VectorXcd values = part(state, from, turn, turn.padded);
        if (is_position) values.array() /= turn.scale;
        values = (turn.unitary * values).eval();
        if (is_position)
          values.array() *= turn.fixed_scale;
        else
          values *= ratio_;
        put(values, turn, turn.scale.size(), to, turned);
        from += turn.parts * turn.padded;
        to += turn.parts * turn.scale.size();
      }
    return turned;
  }
  Eigen::VectorXd of_march(const Eigen::VectorXd& state) const {
    Eigen::VectorXd turned = Eigen::VectorXd::Zero(map_.symmetric().state().size());
    Eigen::Index from = 0, to = 0;
    for (const Turn& turn : turns_)
      for (const bool is_position : {true, false}) {
        Eigen::VectorXcd values = part(state, from, turn, turn.scale.size());
        if (is_position) values.array() /= turn.fixed_scale;
        values = (turn.unitary.adjoint() * values).eval();
        if (is_position)
          values.array() *= turn.scale;
        else
          values /= ratio_;
        put(values, turn, turn.padded, to, turned);
        from += turn.parts * turn.scale.size();
        to += turn.parts * turn.padded;
      }
    return turned;
  }

  double amplitude(const Eigen::VectorXd& state) {
    const std::int64_t start = march_.step_count();
    map_.put(of_march(state));
    const int samples = scene_.scope.samples_per_revolution;
    Recording recording(march_, {samples, 1, 1, 1.0, 1.0});
    recording.revolution(march_);
    march_.set_step(start);
    return recording.finish(march_).amplitude;
  }

 private:
  struct Turn {
    Eigen::MatrixXcd unitary;
    Eigen::ArrayXd scale, fixed_scale;  ///< [rad/s] of positions, here and at the reference speed
    Eigen::Index padded;                ///< modes as the march counts them
    int parts;                          ///< real, and of a travelling wave imaginary
  };

  std::int64_t grown_steps() const {
    return static_cast<std::int64_t>(std::ceil(scene_.casing.ramp_revolutions)) * march_.steps_per_revolution();
  }
  Eigen::Index size() const {
    Eigen::Index size = 0;
    for (const Turn& turn : turns_) size += 2 * turn.parts * turn.scale.size();
    return size;
  }
  static Eigen::VectorXcd part(const Eigen::VectorXd& state, Eigen::Index from, const Turn& turn,
                               Eigen::Index stride) {
    Eigen::VectorXcd values = Eigen::VectorXcd::Zero(turn.scale.size());
    values.real() = state.segment(from, values.size());
    if (turn.parts == 2) values.imag() = state.segment(from + stride, values.size());
    return values;
  }
  static void put(const Eigen::VectorXcd& values, const Turn& turn, Eigen::Index stride, Eigen::Index to,
                  Eigen::VectorXd& state) {
    state.segment(to, values.size()) = values.real();
    if (turn.parts == 2) state.segment(to + stride, values.size()) = values.imag();
  }

  const Scene& scene_;
  TimeMarch march_;
  MarchedMap map_;
  double ratio_;  ///< [1] of the reference speed to this one
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
  return std::lcm(scene_.model.sector_count, scene_.casing.lobes);
}

Eigen::VectorXd OrbitFamily::of_family(double speed, const Eigen::VectorXd& state) {
  return map(speed)->of_family(state);
}

Eigen::VectorXd OrbitFamily::of_march(double speed, const Eigen::VectorXd& state) {
  return map(speed)->of_march(state);
}

}  // namespace tiprub
