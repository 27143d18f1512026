# SPDX-License-Identifier: GPL-3.0-or-later
set terminal svg size 1200,900 font "DejaVu Sans,13" background "white"
set output "chart.svg"
set datafile separator "\t"
set multiplot layout 2,2
set logscale xy
cost = "< grep '^[0-9]' cost.tsv"
set grid
seconds(x) = a * x**p
gibibytes(x) = b * x**q
a = 1e-4; p = 1.2; b = 1e-5; q = 1.1
set fit quiet logfile "/dev/null"
fit log(a) + p * log(x) cost using 1:(log($6)) via a, p
fit log(b) + q * log(x) cost using 1:(log($7)) via b, q
set key bottom right
set xrange [8000:160000]
set xtics (10000, 20000, 50000, 100000)
set title "Cost over the size of the mesh: time"
set xlabel "dofs of the sector"
set ylabel "time [s]"
plot cost using 1:6 with points pt 7 title "processor", seconds(x) title sprintf("dofs^{%.2f}", p), \
     cost using 1:5 with points pt 6 title "wall"
set title "Cost over the size of the mesh: memory"
set ylabel "peak memory [GiB]"
plot cost using 1:7 with points pt 7 title "peak", cost using 1:8 with points pt 6 title "expected before the start", gibibytes(x) title sprintf("dofs^{%.2f}", q)
unset logscale x
set xrange [400:1400]
set xtics auto
set key top right samplen 2
set yrange [1e-4:3]
set ylabel "worst error of the first 50 frequencies [%]"
set title "Error over the size of the model"
set xlabel "dofs of the whole wheel's model at any one speed"
of(name) = sprintf("< grep '^%s' error.tsv", name)
plot for [name in "stress_only linear nonlinear"] of(name) using 6:7 with points pt 7 ps 0.9 title name noenhanced, \
     0.1 with lines lc "gray" title "0.1 %", 0.01 with lines dt 2 lc "gray" title "0.01 %"
set title "Error over the time of the reduction"
set xlabel "processor time [s]"
set logscale x
set xrange [3:40]
set xtics (3, 5, 10, 20, 40)
set key bottom left
plot for [name in "stress_only linear nonlinear"] of(name) using 9:7 with points pt 7 ps 0.9 title name noenhanced, \
     0.1 with lines lc "gray" title "0.1 %", 0.01 with lines dt 2 lc "gray" title "0.01 %"
unset multiplot
