// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/wheel/surface_colours.h"

#include <algorithm>
#include <cstdio>

namespace tiprub {

namespace {

Rgb rgb(int number) {
  return Rgb(static_cast<float>(number >> 16 & 255), static_cast<float>(number >> 8 & 255),
             static_cast<float>(number & 255)) /
         255.0f;
}

}  // namespace

Rgb Palette::at(double fraction) const {
  const double place = (fraction > 0 ? std::min(fraction, 1.0) : 0.0) * static_cast<double>(stops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const auto share = static_cast<float>(place - static_cast<double>(below));
  return (1 - share) * rgb(stops[below]) + share * rgb(stops[below + 1]);
}

std::vector<std::string> Palette::names() const {
  std::vector<std::string> names;
  for (const int stop : stops) {
    char name[16];
    std::snprintf(name, sizeof name, "#%06x", static_cast<unsigned>(stop));
    names.emplace_back(name);
  }
  return names;
}

const Palette& displacement_palette() {
  static const Palette palette{{0xe6eaee, 0xc7e9b4, 0x7fcdbb, 0x41b6c4, 0x1d91c0, 0x225ea8, 0x253494, 0x081d58}};
  return palette;
}

const Palette& stress_palette() {
  static const Palette palette{
      {0xfcfdd0, 0xfeca8d, 0xfd9668, 0xf1605d, 0xcd4071, 0x9e2f7f, 0x721f81, 0x440f76, 0x180f3d}};
  return palette;
}

Eigen::Matrix3Xf painted(const Eigen::VectorXd& values, double largest, const Palette& palette) {
  Eigen::Matrix3Xf colours(3, values.size());
  for (Eigen::Index i = 0; i < values.size(); ++i) colours.col(i) = palette.at(values[i] / largest);
  return colours;
}

}  // namespace tiprub
