// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/field_study.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include "mesh/cells/cell_kind.h"
#include "postprocess/fields/cell_stress.h"
#include "postprocess/fields/sector_geometry.h"
#include "postprocess/waves/aliasing.h"
#include "reduce/model/dense_eigen.h"

namespace tiprub::postprocess {

namespace {

constexpr int most_nodal_diameters = 3;  // examined
constexpr int lowest_families = 2;       // drawn, of all that are examined
constexpr int most_families = 8;         // examined, of those that the reduction was verified with

/// The nodal diameters that the casing's first harmonics drive (eq. 17), ascending.
std::vector<int> driven_nodal_diameters(int casing_lobes, int sectors) {
  std::set<int> chosen;
  const int lobes = std::max(1, casing_lobes);
  for (int k = 1; k <= sectors && chosen.size() < most_nodal_diameters; ++k)
    chosen.insert(aliased_nodal_diameter(k * lobes, sectors));
  return {chosen.begin(), chosen.end()};
}

/// How many families of a nodal diameter are examined.
Eigen::Index families_of(const ReducedModel& model, int nodal_diameter) {
  const auto n = static_cast<std::size_t>(nodal_diameter);
  const Eigen::Index verified =
      n < model.verification.unreduced.size() ? model.verification.unreduced[n].cols() : lowest_families;
  return std::min({model.nodal_diameters[n].M.rows(), std::max<Eigen::Index>(verified, lowest_families),
                   Eigen::Index{most_families}});
}

/// A mode has any size and any phase: its largest component becomes 1.
void normalise(Eigen::Matrix3Xcd& shape) {
  Eigen::Index row = 0, column = 0;
  shape.cwiseAbs().maxCoeff(&row, &column);
  if (shape(row, column) != 0.0) shape /= shape(row, column);
}

/// The modes of a nodal diameter, recovered on the sector.
std::vector<ModeField> recovered(const FieldsReader& reader, const ReducedModel& model, int nodal_diameter,
                                 double speed) {
  const NodalDiameterModel& matrices = model.nodal_diameters[static_cast<std::size_t>(nodal_diameter)];
  const auto [squares, vectors] = eigenpairs(matrices.stiffness(speed), matrices.M);
  const Eigen::MatrixXcd shapes = reader.expand(nodal_diameter, vectors.leftCols(families_of(model, nodal_diameter)));
  std::vector<ModeField> modes;
  for (int family = 0; family < shapes.cols(); ++family) {
    WaveField wave{nodal_diameter, cartesian(reader.sector(), shapes.col(family)), {}};
    normalise(wave.displacement);
    const double frequency = std::sqrt(std::max(0.0, squares[family])) / (2 * std::numbers::pi);
    modes.push_back({family, frequency, std::move(wave)});
  }
  return modes;
}

double disc_share(const ModeShares& mode) {
  const auto known = mode.share.find(disc_part);
  return known == mode.share.end() ? 0 : known->second;
}

}  // namespace

std::map<std::string, double> part_shares(const SectorFields& sector, const Eigen::VectorXd& volumes,
                                          const Eigen::Matrix3Xcd& displacement) {
  const Eigen::VectorXd square = displacement.colwise().squaredNorm();
  const auto of_cell = [&](int cell) { return volumes[cell] * square(nodes_of(sector.cells, cell)).mean(); };
  double whole = 0;
  for (int cell = 0; cell < sector.cells.cols(); ++cell) whole += of_cell(cell);
  std::map<std::string, double> shares;
  for (const auto& [part, cells] : sector.parts)
    for (const int cell : cells) shares[part] += whole > 0 ? of_cell(cell) / whole : 0;
  return shares;
}

std::vector<std::size_t> disc_modes(const std::vector<ModeShares>& shares, int first) {
  std::map<int, std::vector<std::size_t>> families;
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (shares[i].family >= first) families[shares[i].family].push_back(i);
  std::vector<std::size_t> best;
  double most = 0;
  for (auto& [family, modes] : families) {
    std::ranges::stable_sort(modes, std::greater(), [&](std::size_t mode) { return disc_share(shares[mode]); });
    modes.resize(std::min<std::size_t>(2, modes.size()));
    double sum = 0;
    for (const std::size_t mode : modes) sum += disc_share(shares[mode]);
    if (sum > most) best = modes;
    most = std::max(most, sum);
  }
  std::ranges::sort(best);
  return best;
}

NaturalModes natural_modes(const FieldsReader& reader, const ReducedModel& model, int lobes, int families,
                           double speed) {
  const int lowest = std::min(lowest_families, families);
  const Eigen::VectorXd volumes = CellStress(reader.sector()).volumes();
  NaturalModes modes;
  std::vector<ModeField> all;
  for (const int n : driven_nodal_diameters(lobes, model.sector_count))
    for (ModeField& mode : recovered(reader, model, n, speed)) {
      modes.shares.push_back(
          {n, mode.family, mode.frequency, part_shares(reader.sector(), volumes, mode.wave.displacement)});
      all.push_back(std::move(mode));
    }
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].family < lowest) modes.drawn.push_back(std::move(all[i]));
  for (const std::size_t i : disc_modes(modes.shares, lowest)) modes.drawn.push_back(std::move(all[i]));
  return modes;
}

}  // namespace tiprub::postprocess
