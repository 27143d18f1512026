# SPDX-License-Identifier: GPL-3.0-or-later
# gnuplot -e 'folder="FOLDER"' scaling.gnuplot: FOLDER/scaling.svg from FOLDER/scaling.tsv of tiprub-benchmark, and from the reductions of
# cases/reduction_cost
set terminal svg size 1200,800 font "DejaVu Sans,13" background "white"
set output folder . "/scaling.svg"
table = folder . "/scaling.tsv"
mesh = "< grep '^[0-9]' cases/reduction_cost/expected/cost.tsv"
set datafile separator "\t"
set multiplot layout 2,3
set logscale xyy2
set grid
set key top left samplen 2
set offsets graph 0.05, graph 0.05, graph 0.3, graph 0.05
set fit quiet logfile "/dev/null"
cost(x) = exp(a) * x**p
need(x) = exp(b) * x**q
set ytics nomirror
set y2tics
set y2label "memory [MiB]"
set ylabel "a revolution [ms]"
array varied[4] = ["blades", "lobes", "contact nodes of a blade", "dofs of a sector's model"]
do for [i=0:3] {
  a = 1; p = 1; b = 1; q = 1
  fit a + p * x table index i using (log($3)):(log($4)) via a, p
  fit b + q * x table index i using (log($3)):(log($5)) via b, q
  set xlabel varied[i + 1]
  plot table index i using 3:4 with points pt 7 lc 1 title "time", cost(x) lc 1 title sprintf("power %.2f", p), \
       table index i using 3:5 axes x1y2 with points pt 6 lc 2 title "memory", need(x) axes x1y2 lc 2 title sprintf("power %.2f", q)
}
a = 1; p = 1
fit a + p * x table index 4 using (log($3)):(log($4)) via a, p
unset y2tics
unset y2label
set xlabel "damping [1]"
set ylabel "a settled speed by march [ms]"
set key top right
plot table index 4 using 3:4 with points pt 7 lc 1 title "time", cost(x) lc 1 title sprintf("power %.2f", p)
a = 1; p = 1; b = 1; q = 1
fit a + p * x mesh using (log($1)):(log($6)) via a, p
fit b + q * x mesh using (log($1)):(log($7 * 1024)) via b, q
set key top left
set y2tics
set y2label "memory [MiB]"
set xlabel "dofs of a sector's mesh"
set ylabel "a reduction [s]"
plot mesh using 1:6 with points pt 7 lc 1 title "time", cost(x) lc 1 title sprintf("power %.2f", p), \
     mesh using 1:($7 * 1024) axes x1y2 with points pt 6 lc 2 title "memory", need(x) axes x1y2 lc 2 title sprintf("power %.2f", q)
unset multiplot
