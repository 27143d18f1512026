// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <sstream>

#include "postprocess/figures/figure.h"
#include "postprocess/figures/figure_style.h"
#include "postprocess/records/sweep_record.h"
#include "postprocess/tables/units.h"

namespace tiprub {

Figure sweeps_figure(const Study& study) {
  const Eigen::VectorXd rpm = style::speeds_rpm(study);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Constant(rpm.size(), 6, std::nan(""));
  for (const SweepComparison& at : study.sweeps) {
    const double rest = study.amplitudes.largest[at.index] * mm_per_m;
    rows(at.index, 0) = rpm[at.index];
    rows(at.index, 1) = rest;
    if (at.up) rows(at.index, 2) = at.up->amplitude * mm_per_m;
    if (at.down) rows(at.index, 3) = at.down->amplitude * mm_per_m;
    if (at.up && at.up->differs) rows(at.index, 4) = at.up->amplitude * mm_per_m;
    if (at.down && at.down->differs) rows(at.index, 5) = at.down->amplitude * mm_per_m;
  }
  const style::SpeedAxis axis = style::speed_axis(study);
  Figure figure;
  figure.drawing = {"sweeps", 1000, 480, ""};
  figure.title = "From rest, upwards, downwards";
  figure.caption =
      "Amplitude of the motion that each speed settles to from rest, and from the motion at the speed below (up) and "
      "above "
      "(down). Where motions differ (filled), there is more than one, and the wheel's past decides.";
  figure.data = sweep_record(study);
  std::ostringstream out;
  out << style::base() << style::block("sweeps", rows) << style::range("x", axis.low, axis.high)
      << "set yrange [0:*]\nset offsets 0,0,graph 0.05,0\nset xlabel 'speed [rpm]'\nset ylabel 'amplitude [mm]'\n"
      << "set lmargin at screen 0.085\nset rmargin at screen 0.975\nset tmargin at screen 0.9\nset bmargin at screen "
         "0.13\n"
      << "set key at screen 0.5,0.96 center center horizontal\n"
      << "plot $sweeps using 1:2 with lines linewidth 1.2 linecolor rgb '#444444' title 'from rest', '' using 1:3 "
         "with "
         "lines linewidth 1.2 linecolor rgb '#d55e00' title 'up', '' using 1:4 with lines linewidth 1.2 dashtype 2 "
         "linecolor rgb '#0072b2' title 'down', '' using 1:5 with points pointtype 9 pointsize 1 linecolor rgb "
         "'#d55e00' "
         "title 'up differs', '' using 1:6 with points pointtype 11 pointsize 1 linecolor rgb '#0072b2' title 'down "
         "differs'\n";
  figure.drawing.commands = out.str();
  return figure;
}

}  // namespace tiprub
