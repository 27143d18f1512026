# SPDX-License-Identifier: GPL-3.0-or-later
set terminal svg size 1000,420 font 'sans-serif,13' background rgb 'white'
set datafile separator '\t'
set border 31 linecolor rgb '#444444'
set samples 10
set output 'waves.svg'
set multiplot layout 1,2
set xrange [0:2*pi]
set yrange [-1.25:1.6]
set xtics ('0' 0, 'π/2' pi/2, 'π' pi, '3π/2' 3*pi/2, '2π' 2*pi)
set xlabel 'angle θ'
set key top center horizontal
do for [pair in '6,4,2,3 8,2,4,5'] {
  high = word(system(sprintf("echo %s | tr , ' '", pair)), 1)
  low = word(system(sprintf("echo %s | tr , ' '", pair)), 2)
  a = int(word(system(sprintf("echo %s | tr , ' '", pair)), 3))
  b = int(word(system(sprintf("echo %s | tr , ' '", pair)), 4))
  set title sprintf('cos(%sθ) and cos(%sθ) at ten blades', high, low)
  plot 'waves.tsv' using 1:a with lines linecolor rgb '#0072b2' title sprintf('cos(%sθ)', high), \
    '' using 1:b with lines dashtype 2 linecolor rgb '#d55e00' title sprintf('cos(%sθ)', low), \
    '' every 72::1 using 1:b with points pointtype 7 pointsize 0.9 linecolor rgb '#222222' title 'blades'
}
unset multiplot
set output 'zigzag.svg'
set title 'Nodal diameter that ten sectors see of an engine order'
set xrange [-0.5:30.5]
set yrange [-0.3:6.4]
set xtics 0,2
set ytics 0,1
set xlabel 'engine order'
set ylabel 'nodal diameter'
set key top center horizontal
set grid linecolor rgb '#dddddd'
plot 'zigzag.tsv' using 1:2 with lines linecolor rgb '#999999' notitle, \
  '' using ($4 == 1 ? $1 : NaN):2 with points pointtype 6 pointsize 1.7 linewidth 1.5 linecolor rgb '#0072b2' title 'two lobes', \
  '' using ($5 == 1 ? $1 : NaN):2 with points pointtype 7 pointsize 0.8 linecolor rgb '#d55e00' title 'three lobes'
set output 'clustering.svg'
set multiplot layout 1,2
set xrange [5:15]
set xtics 1
set yrange [0:1.8]
set ytics autofreq
set xlabel 'engine order'
set ylabel 'amplitude'
set key top right
set style fill solid noborder
set title 'one sector over time: one peak'
plot 'clustering.tsv' using 1:2 with impulses linewidth 4 linecolor rgb '#444444' notitle
set title 'all sectors, by nodal diameter: two'
plot 'clustering.tsv' using ($1-0.06):3 with impulses linewidth 4 linecolor rgb '#0072b2' title 'nodal diameter 0', \
  '' using ($1+0.06):5 with impulses linewidth 4 linecolor rgb '#d55e00' title 'nodal diameter 2'
unset multiplot
