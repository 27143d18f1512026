// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "mesh/cells/cell_kind.h"
#include "postprocess/fields/sector_geometry.h"
#include "postprocess/figures/axes.h"
#include "postprocess/figures/study_figures.h"

namespace tiprub::postprocess {

namespace {

constexpr int side = 420;                  // [px] of a panel
constexpr float folded = 0.8F;             // cosine of the angle beyond which an edge between faces is drawn
constexpr double depth_step = 0.03;        // of the extent, likewise
constexpr double least_of_largest = 1e-4;  // where the colours begin
constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

/// A picture of values on a surface, the nearest of which is seen at each pixel. Rows go up.
class Picture {
 public:
  /// Columns of `axes`: to the right, up, towards the eye.
  Picture(const Eigen::Matrix3d& axes, const Eigen::Vector3d& centre, double extent)
      : axes_(axes), centre_(centre), extent_(extent) {
    values_.setConstant(side, side, nothing);
    depth_.setConstant(side, side, -std::numeric_limits<double>::infinity());
    for (Eigen::MatrixXf& component : normal_) component.setZero(side, side);
  }

  /// A triangle, seen from both sides.
  void add(const Eigen::Matrix3d& corners, float value) {
    const Eigen::Matrix3d seen = axes_.transpose() * (corners.colwise() - centre_) / extent_;
    const Eigen::Matrix2Xd at = (seen.topRows<2>().array() + 0.5) * side;
    const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a[0] * b[1] - a[1] * b[0]; };
    const Eigen::Vector2d along = at.col(1) - at.col(0), beside = at.col(2) - at.col(0);
    const double area = cross(along, beside);
    if (area == 0) return;
    Eigen::Vector3d normal = (seen.col(1) - seen.col(0)).cross(seen.col(2) - seen.col(0)).normalized();
    if (normal[2] < 0) normal = -normal;
    const auto pixel = [](double x) { return std::clamp(static_cast<int>(std::ceil(x - 0.5)), 0, side); };
    for (int row = pixel(at.row(1).minCoeff()); row < pixel(at.row(1).maxCoeff()); ++row)
      for (int column = pixel(at.row(0).minCoeff()); column < pixel(at.row(0).maxCoeff()); ++column) {
        const Eigen::Vector2d from = Eigen::Vector2d(column + 0.5, row + 0.5) - at.col(0);
        const double s = cross(from, beside) / area, t = cross(along, from) / area;
        if (s < 0 || t < 0 || s + t > 1) continue;
        const double depth = (1 - s - t) * seen(2, 0) + s * seen(2, 1) + t * seen(2, 2);
        if (depth <= depth_(row, column)) continue;
        depth_(row, column) = depth;
        values_(row, column) = value;
        for (std::size_t d = 0; d < 3; ++d) normal_[d](row, column) = static_cast<float>(normal[static_cast<int>(d)]);
      }
  }

  /// The values, with gaps along outlines and folds.
  Eigen::MatrixXf outlined() const {
    Eigen::MatrixXf drawn = values_;
    for (int row = 1; row < side; ++row)
      for (int column = 1; column < side; ++column)
        if (is_edge(row, column, row - 1, column) || is_edge(row, column, row, column - 1))
          drawn(row, column) = nothing;
    return drawn;
  }

 private:
  bool is_edge(int row, int column, int other_row, int other_column) const {
    float cosine = 0;
    for (const Eigen::MatrixXf& component : normal_)
      cosine += component(row, column) * component(other_row, other_column);
    return std::abs(depth_(row, column) - depth_(other_row, other_column)) > depth_step || cosine < folded;
  }

  Eigen::Matrix3d axes_;
  Eigen::Vector3d centre_;
  double extent_;
  Eigen::MatrixXf values_;
  Eigen::MatrixXd depth_;
  std::array<Eigen::MatrixXf, 3> normal_;
};

/// From one side around the axis or the other, a little from outside; the radius through the contact nodes goes up.
Eigen::Matrix3d view(const SectorFields& sector, double from) {
  const std::vector<int>& contact = sector.node_set("contact");
  const Eigen::Vector3d tip = sector.nodes(Eigen::all, contact).rowwise().mean();
  const double angle = std::atan2(tip[1], tip[0]);
  const Eigen::Vector3d radial(std::cos(angle), std::sin(angle), 0), around(-std::sin(angle), std::cos(angle), 0);
  const Eigen::Vector3d eye = (from * around + 0.4 * radial + 0.5 * from * Eigen::Vector3d::UnitZ()).normalized();
  const Eigen::Vector3d right = radial.cross(eye).normalized();
  Eigen::Matrix3d axes;
  axes << right, eye.cross(right), eye;
  return axes;
}

/// The surface, by triangles about the middle of each face.
void add_surface(const SectorFields& sector, const std::vector<SurfaceFace>& faces, const Eigen::VectorXd& of_cells,
                 Picture& picture) {
  for (const SurfaceFace& face : faces) {
    const auto corners = static_cast<std::size_t>(face.corners());
    std::vector<int> around;
    for (std::size_t k = 0; k < face.nodes.size(); ++k)
      around.push_back(face.nodes[k % 2 == 0 ? k / 2 : corners + k / 2]);
    const Eigen::Vector3d middle = sector.nodes(Eigen::all, around).rowwise().mean();
    for (std::size_t k = 0; k < around.size(); ++k) {
      Eigen::Matrix3d triangle;
      triangle << middle, sector.nodes.col(around[k]), sector.nodes.col(around[(k + 1) % around.size()]);
      picture.add(triangle, static_cast<float>(of_cells[face.cell]));
    }
  }
}

/// The share [%] of each cell in the whole.
Eigen::VectorXd shares(const Eigen::VectorXd& errors) {
  const double sum = errors.sum();
  return sum > 0 ? Eigen::VectorXd(errors * (percent / sum)) : Eigen::VectorXd::Zero(errors.size());
}

Table share_table(const SectorFields& sector, const Eigen::VectorXd& frequency, const Eigen::VectorXd& compliance) {
  Table table{{"cell", "x [mm]", "y [mm]", "z [mm]", "share of frequencies [%]", "share of compliances [%]"}, {}};
  for (Eigen::Index cell = 0; cell < sector.cells.cols(); ++cell) {
    const Eigen::Vector3d middle = mm_per_m * sector.nodes(Eigen::all, nodes_of(sector.cells, cell)).rowwise().mean();
    table.rows.push_back(
        {static_cast<int>(cell), middle[0], middle[1], middle[2], frequency[cell], compliance[cell]});
  }
  return table;
}

}  // namespace

Figure mesh_error_figure(const FieldStudy& fields) {
  const SectorFields& sector = fields.sector;
  const Eigen::VectorXd frequency = shares(fields.mesh_error_of_frequencies),
                        compliance = shares(fields.mesh_error_of_compliances);
  const std::vector<SurfaceFace> faces = sector_surface(sector);
  const Eigen::Vector3d low = sector.nodes.rowwise().minCoeff(), high = sector.nodes.rowwise().maxCoeff();
  const double largest = std::max(frequency.maxCoeff(), compliance.maxCoeff());
  Eigen::MatrixXf pixels(2 * side, 2 * side);
  for (const int column : {0, 1})
    for (const int row : {0, 1}) {
      Picture picture(view(sector, column == 0 ? 1.0 : -1.0), (low + high) / 2, (high - low).norm());
      add_surface(sector, faces, (row == 1 ? frequency : compliance).cwiseMax(least_of_largest * largest), picture);
      pixels.block(side * row, side * column, side, side) = picture.outlined();
    }
  Eigen::Index worst = 0;
  frequency.maxCoeff(&worst);
  const double place = sector.nodes(Eigen::all, nodes_of(sector.cells, worst)).rowwise().mean().head<2>().norm();
  Figure figure = listed_figure("mesh_error", {{"largest", significant(frequency[worst], 2)},
                                               {"radius", fixed(mm_per_m * place, 1)},
                                               {"cells", std::to_string(sector.cells.cols())}});
  figure.drawing.values = {{"share", DrawnRange{least_of_largest * largest, largest}.widened()}};
  set_pixels(figure, std::move(pixels));
  figure.data = share_table(sector, frequency, compliance);
  return figure;
}

}  // namespace tiprub::postprocess
