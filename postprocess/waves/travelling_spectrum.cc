// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/waves/travelling_spectrum.h"

#include <fftw3.h>

#include <cassert>
#include <cmath>
#include <complex>
#include <memory>
#include <vector>

#include "postprocess/waves/aliasing.h"

namespace tiprub::postprocess {

namespace {

Eigen::RowVector3d direction_of(const ContactLine& contact, int node, Component component) {
  if (component == Component::normal) return contact.normal.row(node);
  return Eigen::RowVector3d::Unit(static_cast<Eigen::Index>(component) -
                                  static_cast<Eigen::Index>(Component::radial));
}

/// a_m of the header: 2 for a line that stands for its mirror image too.
double mirror_factor(Eigen::Index line, Eigen::Index samples) {
  return line == 0 || 2 * line == samples ? 1.0 : 2.0;
}

}  // namespace

Eigen::MatrixXd tip_motion(const SpeedResponse& response, const SimulatedScene& scene, const ContactLine& contact,
                           int node, Component component) {
  const Eigen::Vector3d direction = direction_of(contact, node, component).transpose();
  const Eigen::Index nodes = scene.clearance.size();
  Eigen::MatrixXd motion(response.displacement.rows(), scene.sector_count);
  for (int sector = 0; sector < scene.sector_count; ++sector) {
    const Eigen::Index first = 3 * ((sector % scene.independent_sectors) * nodes + node);
    motion.col(sector) = response.displacement.middleCols(first, 3) * direction;
  }
  return motion;
}

Eigen::MatrixXd tip_force(const SpeedResponse& response, const SimulatedScene& scene, int node) {
  Eigen::MatrixXd force(response.contact_force.rows(), scene.sector_count);
  for (int sector = 0; sector < scene.sector_count; ++sector)
    force.col(sector) =
        response.contact_force.col((sector % scene.independent_sectors) * scene.clearance.size() + node);
  return force;
}

double vibration_amplitude(const Eigen::MatrixXd& motion) {
  if (motion.size() == 0) return 0.0;
  return 0.5 * (motion.colwise().maxCoeff() - motion.colwise().minCoeff()).maxCoeff();
}

TravellingSpectrum travelling_spectrum(const Eigen::MatrixXd& motion, int revolutions) {
  assert(motion.size() > 0 && revolutions >= 1);
  const Eigen::Index samples = motion.rows(), sectors = motion.cols(), lines = samples / 2 + 1;
  Eigen::MatrixXd in(samples, sectors);  // column by column: sectors x samples, the last fastest, as FFTW wants it
  std::vector<std::complex<double>> out(static_cast<std::size_t>(lines * sectors));
  const std::unique_ptr<fftw_plan_s, decltype(&fftw_destroy_plan)> plan(
      fftw_plan_dft_r2c_2d(static_cast<int>(sectors), static_cast<int>(samples), in.data(),
                           reinterpret_cast<fftw_complex*>(out.data()), FFTW_ESTIMATE),
      &fftw_destroy_plan);
  in = motion;
  fftw_execute(plan.get());

  TravellingSpectrum spectrum;
  spectrum.sector_count = static_cast<int>(sectors);
  spectrum.revolutions = revolutions;
  const Eigen::Map<const Eigen::MatrixXcd> transform(out.data(), lines, sectors);
  // eq. 19: the amplitudes a_m |X(m, n)| of its waves; a row is eq. 20
  spectrum.amplitude = transform.cwiseAbs() / static_cast<double>(samples * sectors);
  for (Eigen::Index m = 0; m < lines; ++m) spectrum.amplitude.row(m) *= mirror_factor(m, samples);
  return spectrum;
}

Eigen::VectorXd line_spectrum(const Eigen::VectorXd& signal) {
  return travelling_spectrum(signal, 1).amplitude.col(0);
}

double TravellingSpectrum::at(double engine_order_wanted, int signed_nodal_diameter) const {
  constexpr double line_tolerance = 1e-9;
  const double line = engine_order_wanted * revolutions;
  const auto nearest = static_cast<Eigen::Index>(std::lround(line));
  if (std::abs(line - static_cast<double>(nearest)) > line_tolerance || nearest >= amplitude.rows()) return 0.0;
  return amplitude(nearest, (signed_nodal_diameter + sector_count) % sector_count);
}

Eigen::MatrixXd TravellingSpectrum::by_nodal_diameter() const {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(amplitude.rows(), sector_count / 2 + 1);
  for (int column = 0; column < sector_count; ++column)
    sum.col(aliased_nodal_diameter(column, sector_count)) += amplitude.col(column);
  return sum;
}

}  // namespace tiprub::postprocess
