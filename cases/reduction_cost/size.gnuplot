# SPDX-License-Identifier: GPL-3.0-or-later
set terminal svg size 1200,450 font "DejaVu Sans,13" background "white"
set output "size.svg"
set datafile separator "\t"
set multiplot layout 1,2
set logscale xy
set grid
set key top left samplen 2
set xrange [2e4:1.3e7]
set xtics ("30 k" 3e4, "100 k" 1e5, "300 k" 3e5, "1 M" 1e6, "3 M" 3e6, "10 M" 1e7)
set xlabel "dofs of the sector"
measured(name) = sprintf("< grep -P '^%s\\t[0-9]' size.tsv", name)
beyond(name) = sprintf("< grep -P '^%s .extrapolated' size.tsv", name)
names = "'CHOLMOD' 'MUMPS on disk'"
set title "Processor time [s]: measured (discs), extrapolated (circles)"
plot for [k=1:2] measured(word(names, k)) using 2:4 with linespoints pt 7 lc k title word(names, k), \
     for [k=1:2] beyond(word(names, k)) using 2:4 with points pt 6 lc k notitle
set title "Peak memory and disk [GiB]"
plot for [k=1:2] measured(word(names, k)) using 2:5 with linespoints pt 7 lc k title "memory, ".word(names, k), \
     for [k=1:2] beyond(word(names, k)) using 2:5 with points pt 6 lc k notitle, \
     measured("MUMPS on disk") using 2:6 with linespoints pt 5 lc 3 title "disk, MUMPS on disk", \
     beyond("MUMPS on disk") using 2:6 with points pt 4 lc 3 notitle
unset multiplot
