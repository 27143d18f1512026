# SPDX-License-Identifier: GPL-3.0-or-later
set terminal svg size 1000,820 font 'sans-serif,13' background rgb 'white'
set output 'convergence.svg'
set datafile separator '\t'
set datafile missing 'NaN'
set border 31 linecolor rgb '#444444'
set grid linecolor rgb '#dddddd'
colours = '#d55e00 #e69f00 #009e73 #56b4e9 #0072b2'
set multiplot
set lmargin at screen 0.08
set rmargin at screen 0.84
set tmargin at screen 0.95
set bmargin at screen 0.52
set title 'Radial motion of the leading edge at 22,500 rpm over the number of modes' offset 0,-0.5
set xlabel 'rotor angle [deg]'
set ylabel 'radial displacement [mm]'
set xrange [0:360]
set xtics 45
set key at screen 0.855,0.95 left top Left reverse
plot for [i=1:5] 'traces.tsv' using 1:13+i with lines linewidth (i == 5 ? 1 : 1.6) linecolor rgb word(colours, i) \
  title sprintf('η = %d', 50*i), \
  'traces.tsv' using 1:19 with lines dashtype 2 linecolor rgb '#000000' title 'all modes'
set tmargin at screen 0.40
set bmargin at screen 0.10
set logscale xy
set format y '10^{%T}'
set autoscale x
set yrange [1e-5:10]
set xtics autofreq
unset key
array over[3] = ['eta', 'steps a revolution', 'dofs a sector']
array low[3] = [40, 400, 2000]
array high[3] = [300, 10000, 60000]
do for [p=1:3] {
  set lmargin at screen 0.08 + (p - 1) * 0.31
  set rmargin at screen 0.08 + (p - 1) * 0.31 + 0.265
  set title ''
  set xlabel over[p]
  set ylabel (p == 1 ? 'difference to the finest [1]' : '')
  set xrange [low[p]:high[p]]
  if (p == 3) { set key at screen 0.855,0.60 left top Left reverse }
  plot for [rpm in '13500 17500 22500'] 'convergence.tsv' \
    using (strcol(1) eq over[p] && strcol(3) eq rpm && $5 > 0 ? $2 : NaN):5 with linespoints pointtype 7 pointsize 0.6 \
    linecolor rgb (rpm eq '13500' ? '#0072b2' : rpm eq '17500' ? '#009e73' : '#d55e00') title sprintf('%s rpm', rpm)
}
unset multiplot
