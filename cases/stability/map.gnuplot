# SPDX-License-Identifier: GPL-3.0-or-later
# The maps of stability.tsv, a panel each, a square a run.
set terminal svg size 1500,2100 font "sans,12" background "white"
set output "map.svg"
set datafile separator "\t"
verdicts = "stable inaccurate chatters grows refused_grows refused_bounded refused periodic subharmonic modulated broadband not_settled"
colours = "#4cae4f #f2b134 #a66bbe #dd181f #b08080 #b9b9b9 #8a8a8a #9ecae1 #4292c6 #fdae6b #e6550d #cccccc"
titles = "stable|inaccurate|chatters|grows|refused, grows|refused, bounded|refused, no march|periodic|subharmonic|modulated|broadband|not settled"
is_class(verdict) = strstrt("periodic subharmonic modulated broadband not_settled", verdict) > 0
text(verdict, number) = verdict eq "refused" || verdict eq "refused_bounded" ? "" : \
  is_class(verdict) ? sprintf("%.2g", number) : \
  verdict eq "grows" || verdict eq "refused_grows" ? sprintf("%+.2g", number) : \
  number >= 0.1 ? sprintf("%.0f %%", 100 * number) : sprintf("%.2g %%", 100 * number)
part(text, i) = i == 1 ? text[1:strstrt(text, "|") - 1] : part(text[strstrt(text, "|") + 1:*], i - 1)
stats "stability.tsv" using 2 nooutput
maps = STATS_blocks
set multiplot layout 6,2 columnsfirst margins 0.16,0.99,0.078,0.98 spacing 0.17,0.055
set key off
do for [i = 0:maps - 1] {
  set autoscale
  stats "stability.tsv" index i using (name = strcol(1), $2):4 nooutput name "place"
  set yrange [place_max_x + 0.5:-0.5]
  set xrange [-0.5:place_max_y + 0.5]
  set title name noenhanced offset 0,-0.6 font ",13"
  if (i == maps - 1) { set key at screen 0.5,0.012 center bottom horizontal maxcols 6 font ",11" samplen 1 }
  plot "stability.tsv" index i using 4:2:xtic(strcol(5)):ytic(strcol(3)) with points pt -1 notitle, \
    for [v = 1:words(verdicts)] "" index i using (strcol(6) eq word(verdicts, v) ? $4 : NaN):2:(0.49):(0.46) \
    with boxxyerror fs solid noborder lc rgb word(colours, v) title part(titles . "|", v), \
    "" index i using 4:2:(text(strcol(6), $7)) with labels font ",10" notitle
}
unset multiplot
