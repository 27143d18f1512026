// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/field_recovery.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <filesystem>
#include <numbers>
#include <numeric>

#include "mesh/cells/cell_kind.h"
#include "postprocess/fields/field_vtu.h"
#include "postprocess/fields/node_stress.h"
#include "postprocess/fields/sector_geometry.h"
#include "postprocess/tables/table.h"
#include "reduce/model/nodal_diameter.h"

namespace tiprub::postprocess::field_recovery_test {
namespace {

constexpr int sector_count = 6;
constexpr double alpha = 2 * std::numbers::pi / sector_count;

/// Two bricks side by side around the axis, curved and skewed, from theta = 0 to alpha; 20 or 27 nodes a brick.
SectorFields sector_of_bricks(int nodes_per_brick) {
  SectorFields sector;
  sector.sector_count = sector_count;
  sector.young = 200e9;
  sector.poisson = 0.3;
  sector.density = 7800;
  std::vector<Eigen::Vector3d> places;
  std::vector<std::array<int, 3>> lattice;
  sector.cells.resize(nodes_per_brick, 2);
  for (int brick = 0; brick < 2; ++brick)
    for (int k = 0; k < nodes_per_brick; ++k) {
      const Eigen::Vector3i place = cell_kind(nodes_per_brick).places[k].cast<int>();
      const std::array<int, 3> at = {place[0], place[1] + 1 + 2 * brick, place[2]};  // 0 .. 4 around
      auto known = std::find(lattice.begin(), lattice.end(), at);
      if (known == lattice.end()) {
        const double r = 0.1 + 0.02 * at[0] + 0.004 * at[2], t = alpha * at[1] / 4;
        const double theta = t + 0.05 * at[0] + 0.03 * std::sin(3.0 * at[2]);
        places.emplace_back(r * std::cos(theta), r * std::sin(theta), 0.015 * at[2] + 0.003 * at[0] * at[0]);
        lattice.push_back(at);
        known = lattice.end() - 1;
      }
      sector.cells(k, brick) = static_cast<int>(known - lattice.begin());
    }
  sector.nodes.resize(3, static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) sector.nodes.col(static_cast<Eigen::Index>(i)) = places[i];
  std::vector<int> low, high;
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    if (lattice[i][1] != 0) continue;
    std::array<int, 3> partner = lattice[i];
    partner[1] = 4;
    low.push_back(static_cast<int>(i));
    high.push_back(static_cast<int>(std::find(lattice.begin(), lattice.end(), partner) - lattice.begin()));
  }
  sector.node_sets = {{"clamped", {}}, {"contact", {0}}, {"cyclic_low", low}, {"cyclic_high", high}};
  sector.static_displacement.terms = {Eigen::Matrix3Xd::Zero(3, sector.nodes.cols())};
  return sector;
}

Eigen::Matrix3d tensor(const Eigen::Matrix<double, 6, 1>& s) {
  Eigen::Matrix3d full;
  full << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  return full;
}

Eigen::Matrix3d turn(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

Eigen::Matrix3d stress_of(const SectorFields& sector, const Eigen::Matrix3d& slope) {
  const Eigen::Matrix3d strain = 0.5 * (slope + slope.transpose());
  const double lambda = sector.young * sector.poisson / (1 + sector.poisson) / (1 - 2 * sector.poisson);
  return lambda * strain.trace() * Eigen::Matrix3d::Identity() + sector.young / (1 + sector.poisson) * strain;
}

/// [Pa] Of the cells of a sector, without its neighbours.
Tensors average_stress(const SectorFields& sector, const Eigen::Matrix3Xd& moved) {
  const CellStress cells(sector);
  const Eigen::Matrix3Xcd both = moved.cast<std::complex<double>>();
  const std::array<ComplexTensors, 2> sums = cells.sums(both, 2 * both);
  EXPECT_EQ(sums[1], 2 * sums[0]);
  return sums[0].real().array().rowwise() / cells.cells_at_node().transpose().cast<double>().array();
}

class Bricks : public ::testing::TestWithParam<int> {};

TEST_P(Bricks, RigidMotionHasNoStress) {
  const SectorFields sector = sector_of_bricks(GetParam());
  const Eigen::Vector3d spin(0.3e-3, -0.2e-3, 0.5e-3), shift(1e-4, 2e-4, -3e-4);
  Eigen::Matrix3Xd moved(3, sector.nodes.cols());
  for (Eigen::Index i = 0; i < moved.cols(); ++i) moved.col(i) = shift + spin.cross(sector.nodes.col(i));
  const double strain_like = sector.young * spin.norm();
  EXPECT_LT(average_stress(sector, moved).cwiseAbs().maxCoeff(), 1e-11 * strain_like);
}

TEST_P(Bricks, ConstantStrainIsExactOnDistortedBricks) {
  const SectorFields sector = sector_of_bricks(GetParam());
  Eigen::Matrix3d slope;
  slope << 1e-3, 4e-4, -2e-4, -3e-4, 5e-4, 6e-4, 7e-4, -8e-4, -9e-4;
  const Tensors stress = average_stress(sector, slope * sector.nodes);
  const Eigen::Matrix3d exact = stress_of(sector, slope);
  for (Eigen::Index i = 0; i < stress.cols(); ++i)
    EXPECT_LT((tensor(stress.col(i)) - exact).norm(), 1e-11 * exact.norm()) << "node " << i;
}

INSTANTIATE_TEST_SUITE_P(Nodes, Bricks, ::testing::Values(20, 27));

/// A brick whose sides are straight: a displacement of second order gives a stress of first order, exactly.
TEST(CellStress, LinearStressIsExactOnAStraightBrick) {
  SectorFields sector = sector_of_bricks(20);
  sector.cells = Eigen::VectorXi::LinSpaced(20, 0, 19);
  sector.nodes.resize(3, 20);
  for (int k = 0; k < 20; ++k)
    for (int d = 0; d < 3; ++d) sector.nodes(d, k) = (1 + 0.3 * d) * cell_kind(20).places[k][d];
  Eigen::Matrix3Xd moved(3, 20);
  for (int k = 0; k < 20; ++k) {
    const Eigen::Vector3d x = sector.nodes.col(k);
    moved.col(k) = 1e-3 * Eigen::Vector3d(x[0] * x[1], x[1] * x[2], x[0] * x[0]);
  }
  const Tensors stress = average_stress(sector, moved);
  for (int k = 0; k < 20; ++k) {
    const Eigen::Vector3d x = sector.nodes.col(k);
    Eigen::Matrix3d slope;
    slope << x[1], x[0], 0, 0, x[2], x[1], 2 * x[0], 0, 0;
    const Eigen::Matrix3d exact = stress_of(sector, 1e-3 * slope);
    EXPECT_LT((tensor(stress.col(k)) - exact).norm(), 1e-11 * sector.young * 1e-3);
  }
}

TEST(VonMises, OfTensionAndShear) {
  Tensors stress(6, 2);
  stress.col(0) << 0, 250e6, 0, 0, 0, 0;
  stress.col(1) << 0, 0, 0, 0, 100e6, 0;
  EXPECT_NEAR(von_mises(stress)[0], 250e6, 1);
  EXPECT_NEAR(von_mises(stress)[1], std::sqrt(3.0) * 100e6, 1);
}

TEST(Turned, IsRSigmaR) {
  Tensors stress(6, 1);
  stress << 1, 2, 3, 4, 5, 6;
  const Eigen::Matrix3d exact = turn(0.7) * tensor(stress.col(0)) * turn(0.7).transpose();
  EXPECT_LT((tensor(turned(stress, 0.7).col(0)) - exact).norm(), 1e-14);
}

/// The whole wheel under one homogeneous strain of the plane: xx - yy and xy make a wave of nodal diameter 2. Every
/// sector, and the faces between them, must show the same tensor.
TEST(OnWheel, HomogeneousStressIsTheSameInEverySector) {
  const SectorFields sector = sector_of_bricks(20);
  Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
  slope(0, 0) = 1e-3;
  slope(1, 1) = -1e-3;
  Eigen::Matrix3d shear = Eigen::Matrix3d::Zero();
  shear(0, 1) = shear(1, 0) = 1e-3;
  // In sector j's own frame the field is R' slope R x: slope cos(2 j alpha) - shear sin(2 j alpha).
  const std::complex<double> i(0, 1);
  WaveField wave{
      2,
      (slope * sector.nodes).cast<std::complex<double>>() + i * (shear * sector.nodes).cast<std::complex<double>>(),
      {}};
  add_stress(sector, CellStress(sector), {&wave, 1});
  const WheelField wheel = on_wheel({wave}, sector_count);
  const Eigen::Matrix3d exact = stress_of(sector, slope);
  for (int j = 0; j < sector_count; ++j) {
    const Eigen::Matrix3Xd moved = slope * nodes_of_sector(sector, j);
    EXPECT_LT((wheel.displacement[j] - moved).norm(), 1e-13 * moved.norm()) << "sector " << j;
    for (Eigen::Index k = 0; k < sector.nodes.cols(); ++k)
      EXPECT_LT((tensor(wheel.stress[j].col(k)) - exact).norm(), 1e-11 * exact.norm())
          << "sector " << j << ", node " << k;
  }
}

Eigen::VectorXcd cyclic_motion(const SectorFields& sector, int n) {
  Eigen::VectorXcd motion(3 * sector.nodes.cols());
  for (Eigen::Index k = 0; k < motion.size(); ++k)
    motion[k] = {std::sin(1.0 + 1.7 * static_cast<double>(k)), n > 0 ? std::cos(2.3 * static_cast<double>(k)) : 0.0};
  const std::vector<int>&low = sector.node_set("cyclic_low"), &high = sector.node_set("cyclic_high");
  for (std::size_t k = 0; k < low.size(); ++k)
    motion.segment<3>(3 * high[k]) = std::polar(1.0, n * alpha) * motion.segment<3>(3 * low[k]);
  return motion;
}

/// The sum of waves meets itself on the faces between sectors, in displacement and in stress.
TEST(OnWheel, NeighboursAgreeOnTheirCommonFace) {
  const SectorFields sector = sector_of_bricks(27);
  const CellStress bricks(sector);
  std::vector<WaveField> waves;
  for (const int n : {0, 1, 2}) waves.push_back({n, cartesian(sector, cyclic_motion(sector, n)), {}});
  add_stress(sector, bricks, waves);
  const WheelField wheel = on_wheel(waves, sector_count);
  const std::vector<int>&low = sector.node_set("cyclic_low"), &high = sector.node_set("cyclic_high");
  for (int j = 0; j < sector_count; ++j)
    for (std::size_t k = 0; k < low.size(); ++k) {
      const int next = (j + 1) % sector_count;
      EXPECT_LT((wheel.displacement[j].col(high[k]) - wheel.displacement[next].col(low[k])).norm(), 1e-12);
      const double scale = wheel.stress[j].cwiseAbs().maxCoeff();
      EXPECT_LT((wheel.stress[j].col(high[k]) - wheel.stress[next].col(low[k])).norm(), 1e-12 * scale);
    }
}

TEST(SectorSurface, IsWhatBricksDontShare) {
  const SectorFields sector = sector_of_bricks(27);
  const std::vector<SurfaceFace> faces = sector_surface(sector);
  int low = 0, high = 0;
  for (const SurfaceFace& face : faces) {
    low += face.side == SurfaceFace::Side::cyclic_low;
    high += face.side == SurfaceFace::Side::cyclic_high;
  }
  EXPECT_EQ(faces.size(), 10u);
  EXPECT_EQ(low, 1);
  EXPECT_EQ(high, 1);
}

/// fields.h5 and back: columns combine to what was written, to single precision.
TEST(FieldsFile, ExpandsWhatItTook) {
  SectorFields sector = sector_of_bricks(20);
  sector.parts = {{"disc", {0}}, {"main_blade", {1}}};
  std::vector<Eigen::Matrix3Xd>& terms = sector.static_displacement.terms;
  terms[0].setRandom();
  terms.insert(terms.end(), {0 * terms[0], terms[0] / 3});
  const Eigen::Index dofs = 37, size = 3 * sector.nodes.cols();
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "tiprub_fields_test.h5";
  std::vector<Eigen::MatrixXcd> bases;
  {
    FieldsWriter writer(path, "test");
    writer.write_sector(sector);
    for (int n = 0; n <= sector_count / 2; ++n) {
      const bool standing = is_standing(n, sector_count);
      bases.emplace_back(Eigen::MatrixXcd::Random(size, dofs));
      if (standing) bases.back().imag().setZero();
      writer.write_basis(n, dofs, standing, [&](Eigen::Index k) { return Eigen::VectorXcd(bases.back().col(k)); });
    }
    writer.close("of this model");
  }
  const FieldsReader reader(path);
  EXPECT_EQ(reader.model_digest(), "of this model");
  EXPECT_EQ(reader.sector().cells, sector.cells);
  EXPECT_EQ(reader.sector().nodes, sector.nodes);
  EXPECT_EQ(reader.sector().node_sets, sector.node_sets);
  EXPECT_EQ(reader.sector().parts, sector.parts);
  EXPECT_EQ(reader.sector().static_displacement.terms, terms);
  const Eigen::Matrix3Xd moved = (4 + 64.0 / 3) * terms[0];  // Omega^2 (1) + Omega^6 (3)
  EXPECT_LT((reader.sector().static_displacement(2.0) - moved).norm(), 1e-14 * moved.norm());
  for (int n = 0; n <= sector_count / 2; ++n) {
    const Eigen::MatrixXcd amplitudes = Eigen::MatrixXcd::Random(dofs, 2), exact = bases[n] * amplitudes;
    EXPECT_EQ(reader.dofs(n), dofs);
    EXPECT_LT((reader.expand(n, amplitudes) - exact).norm(), 1e-6 * exact.norm());
  }
  EXPECT_THROW(reader.expand(0, Eigen::MatrixXcd::Zero(dofs + 1, 1)), std::runtime_error);
  std::filesystem::remove(path);
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

TEST(VtuFile, NamesItsArraysAndCells) {
  const SectorFields sector = sector_of_bricks(20);
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "tiprub_vtu_test.vtu";
  write_vtu({sector.nodes, sector.cells}, {{"displacement", sector.nodes}, {"stress", Tensors::Zero(6, 32)}},
            {{"speed", 0.1}}, path);
  const std::string text = read_text(path);
  std::filesystem::remove(path);
  EXPECT_NE(text.find("NumberOfPoints=\"32\" NumberOfCells=\"2\""), std::string::npos);
  EXPECT_NE(text.find("Name=\"stress\" type=\"Float32\" NumberOfComponents=\"6\""), std::string::npos);
  // One block of 2 bytes, 10 when compressed; and what Python's zlib, at its fastest, makes of the types, 19 19.
  EXPECT_NE(text.find("AQAAAAAAAAACAAAAAAAAAAAAAAAAAAAACgAAAAAAAAA=eAGTlAQAAE0AMw=="), std::string::npos);
  EXPECT_NE(text.find("<DataArray Name=\"speed\" type=\"Float64\" NumberOfTuples=\"1\" format=\"ascii\">0.1"),
            std::string::npos);
  EXPECT_EQ(count(text, "<DataArray"), count(text, "</DataArray>"));
  EXPECT_EQ(text.find("<CellData>"), std::string::npos);
  write_vtu({sector.nodes, sector.cells}, {}, {}, path, {{"error", Eigen::RowVector2d(1, 2)}});
  EXPECT_NE(read_text(path).find("<CellData>\n<DataArray Name=\"error\" type=\"Float32\" NumberOfComponents=\"1\""),
            std::string::npos);
  std::filesystem::remove(path);
}

TEST(OtherMesh, HasTheNodesThatAreNearest) {
  const SectorFields sector = sector_of_bricks(20), other = sector_of_bricks(27);
  StressZones zones;
  zones.at_node.assign(static_cast<std::size_t>(other.nodes.cols()), StressZone::body);
  std::vector<int> all(static_cast<std::size_t>(sector.nodes.cols())), others(zones.at_node.size());
  std::iota(all.begin(), all.end(), 0);
  std::iota(others.begin(), others.end(), 0);
  EXPECT_EQ(nodes_near(all, sector, other, zones), others);
  const auto same_place = [&](int node) {
    Eigen::Index same = 0;
    EXPECT_LT((other.nodes.colwise() - sector.nodes.col(node)).colwise().norm().minCoeff(&same), 1e-12);
    return static_cast<int>(same);
  };
  const int there = same_place(3);
  const std::vector<int> found = nodes_near({3}, sector, other, zones);
  EXPECT_TRUE(std::ranges::count(found, there) == 1 && found.size() < 5) << found.size();
  for (const int node : all) EXPECT_EQ(std::ranges::count(found, same_place(node)), node == 3 ? 1 : 0) << node;
  zones.at_node[static_cast<std::size_t>(there)] = StressZone::tip_patch;
  EXPECT_EQ(std::ranges::count(nodes_near({3}, sector, other, zones), there), 0);
}

}  // namespace
}  // namespace tiprub::postprocess::field_recovery_test
