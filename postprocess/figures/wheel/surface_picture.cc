// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/wheel/surface_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tiprub {

namespace {

constexpr int oversampling = 3;  // samples a pixel, each way
constexpr double filled = 0.97;  // of a panel; deformed shapes need a little more
constexpr float nothing = -std::numeric_limits<float>::infinity();
constexpr float ambient = 0.42f, from_viewer = 0.28f, from_light = 0.36f;
constexpr float crease_cosine = 0.8f;  // normals further apart make a line
constexpr float step_depth = 4.0f;     // [samples] a jump in depth beyond what the slope explains makes a line
constexpr float line_shade = 0.35f;
constexpr double bias = 2.5;  // [samples] lines and balls lie this far before their surface
const Eigen::Vector3f light = Eigen::Vector3f(-0.35f, 0.55f, 0.76f).normalized();

}  // namespace

SurfacePicture::SurfacePicture(int width, int height)
    : width_(oversampling * width),
      height_(oversampling * height),
      samples_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_),
               {nothing, Eigen::Vector3f::Zero(), Rgb::Ones()}) {}

void SurfacePicture::begin_panel(int left, int top, int width, int height, const View& view) {
  axes_.row(2) = view.towards_viewer.normalized();
  axes_.row(0) = view.up.cross(view.towards_viewer).normalized();
  axes_.row(1) = axes_.row(2).transpose().cross(axes_.row(0).transpose());
  const Eigen::Matrix2Xd flat = axes_.topRows<2>() * view.seen;
  const Eigen::Vector2d low = flat.rowwise().minCoeff(), high = flat.rowwise().maxCoeff();
  middle_ = 0.5 * (low + high);
  panel_ = oversampling * Eigen::Vector4i(left, top, left + width, top + height);
  panel_middle_ << 0.5 * (panel_[0] + panel_[2]), 0.5 * (panel_[1] + panel_[3]);
  scale_ = filled * oversampling * std::min(width / (high - low).x(), height / (high - low).y());
}

Eigen::Vector3d SurfacePicture::project(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d seen = axes_ * point;
  return {panel_middle_.x() + scale_ * (seen.x() - middle_.x()),
          panel_middle_.y() - scale_ * (seen.y() - middle_.y()), scale_ * seen.z()};
}

Eigen::Vector2d SurfacePicture::place_of(const Eigen::Vector3d& point) const {
  return project(point).head<2>() / oversampling;
}

void SurfacePicture::triangle(const Corner& a, const Corner& b, const Corner& c) {
  const Eigen::Vector3d p = project(a.place), q = project(b.place), r = project(c.place);
  const double area = (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
  if (area == 0) return;
  const int left = std::max(panel_[0], static_cast<int>(std::ceil(std::min({p.x(), q.x(), r.x()}))));
  const int right = std::min(panel_[2] - 1, static_cast<int>(std::floor(std::max({p.x(), q.x(), r.x()}))));
  const int top = std::max(panel_[1], static_cast<int>(std::ceil(std::min({p.y(), q.y(), r.y()}))));
  const int bottom = std::min(panel_[3] - 1, static_cast<int>(std::floor(std::max({p.y(), q.y(), r.y()}))));
  const auto facing = [&](const Corner& corner) {
    const Eigen::Vector3f normal = (axes_ * corner.normal).normalized().cast<float>();
    return normal.z() < 0 ? Eigen::Vector3f(-normal) : normal;
  };
  const Eigen::Vector3f na = facing(a), nb = facing(b), nc = facing(c);
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) {
      const double v = ((x - p.x()) * (r.y() - p.y()) - (y - p.y()) * (r.x() - p.x())) / area;
      const double w = ((q.x() - p.x()) * (y - p.y()) - (q.y() - p.y()) * (x - p.x())) / area;
      const double u = 1 - v - w;
      if (u < 0 || v < 0 || w < 0) continue;
      const auto depth = static_cast<float>(u * p.z() + v * q.z() + w * r.z());
      Sample& hit = sample(x, y);
      if (depth <= hit.depth) continue;
      const auto fu = static_cast<float>(u), fv = static_cast<float>(v), fw = static_cast<float>(w);
      hit = {depth, (fu * na + fv * nb + fw * nc).normalized(), fu * a.colour + fv * b.colour + fw * c.colour};
    }
}

void SurfacePicture::dot(double x, double y, double depth, double radius, const Rgb& colour) {
  for (int row = std::max(panel_[1], static_cast<int>(y - radius));
       row <= std::min(panel_[3] - 1, static_cast<int>(y + radius)); ++row)
    for (int column = std::max(panel_[0], static_cast<int>(x - radius));
         column <= std::min(panel_[2] - 1, static_cast<int>(x + radius)); ++column) {
      const double dx = column - x, dy = row - y, height = radius * radius - dx * dx - dy * dy;
      if (height < 0) continue;
      Sample& hit = sample(column, row);
      if (depth + bias < hit.depth) continue;
      const Eigen::Vector3d normal(dx / radius, -dy / radius, std::sqrt(height) / radius);
      hit.normal = normal.cast<float>();
      hit.colour = colour;
      hit.depth = std::max(hit.depth, static_cast<float>(depth));
    }
}

void SurfacePicture::line(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Rgb& colour, double width_px) {
  const Eigen::Vector3d from = project(a), to = project(b);
  const double radius = 0.5 * oversampling * width_px;
  const int steps = std::max(1, static_cast<int>(std::ceil((to - from).head<2>().norm() / std::max(0.5, radius))));
  for (int i = 0; i <= steps; ++i) {
    const Eigen::Vector3d here = from + (to - from) * i / steps;
    for (int y = static_cast<int>(std::ceil(here.y() - radius)); y <= here.y() + radius; ++y)
      for (int x = static_cast<int>(std::ceil(here.x() - radius)); x <= here.x() + radius; ++x) {
        if (x < panel_[0] || x >= panel_[2] || y < panel_[1] || y >= panel_[3]) continue;
        Sample& hit = sample(x, y);
        if (here.z() + bias >= hit.depth) hit.colour = colour;
      }
  }
}

void SurfacePicture::ball(const Eigen::Vector3d& place, const Rgb& colour, double radius_px) {
  const Eigen::Vector3d here = project(place);
  const double radius = oversampling * radius_px;
  dot(here.x(), here.y(), here.z() + radius, radius, colour);
}

Rgb SurfacePicture::shaded(int x, int y) const {
  const Sample& here = sample(x, y);
  if (here.depth == nothing) return Rgb::Ones();
  float brightness = ambient + from_viewer * here.normal.z() + from_light * std::max(0.0f, here.normal.dot(light));
  for (const auto& [dx, dy] : {std::pair{1, 0}, std::pair{0, 1}}) {
    if (x + dx >= width_ || y + dy >= height_) continue;
    const Sample& other = sample(x + dx, y + dy);
    // A plane as steep as this one falls by n_x/n_z a here.
    const float slope = std::abs(dx != 0 ? here.normal.x() : here.normal.y()) / std::max(0.1f, here.normal.z());
    const bool jump = other.depth == nothing || std::abs(other.depth - here.depth) > step_depth + 2 * slope;
    if (jump || other.normal.dot(here.normal) < crease_cosine) brightness *= line_shade;
  }
  return (brightness * here.colour).cwiseMin(1.0f);
}

Eigen::MatrixXf SurfacePicture::pixels() const {
  const int rows = height_ / oversampling, columns = width_ / oversampling;
  Eigen::MatrixXf picture(rows, 3 * columns);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      Rgb sum = Rgb::Zero();
      for (int dy = 0; dy < oversampling; ++dy)
        for (int dx = 0; dx < oversampling; ++dx) sum += shaded(oversampling * column + dx, oversampling * row + dy);
      for (int k = 0; k < 3; ++k)
        picture(rows - 1 - row, 3 * column + k) =
            std::round(255.0f * sum[k] / static_cast<float>(oversampling * oversampling));
    }
  return picture;
}

}  // namespace tiprub
