# Copyright the limpet authors. GPL-3.0-or-later.
# What exactness costs in single operations: median and tenths of the ratio of time.
#   gnuplot -e "folder='out/predicates'" benchmarks/plots/predicates_operations.gp
load 'benchmarks/plots/style.gp'
set datafile columnheaders
file = folder.'/operations.csv'
set terminal pngcairo size 1000,760 font 'sans,10'
set output folder.'/operations.png'
set bmargin 9
set key outside bottom center horizontal Left reverse
set logscale y
set xtics rotate by -45
set ytics (0.5, 0.7, 1, 1.5, 2, 3, 5, 7, 10, 20, 50)
set arrow 1 from graph 0, first 1 to graph 1, first 1 nohead lc rgb grey
set xtics ()
regimes = 'grid free far'
operations = 'extend merge unite fill'
do for [r = 0:2] { do for [o = 0:3] { set xtics add (word(operations, o + 1).', '.word(regimes, r + 1) 4 * r + o) } }
set xrange [-0.5:11.7]
if_at(position, y) = strcol('position') eq position ? column(y) : NaN
set multiplot layout 2,1
do for [position in 'general degenerate'] {
  set title 'Operations, '.position.' input: time, exact over float'
  plot file using (int($0) % 12):(if_at(position, 'time_ratio_float-grid')):'low_float-grid':'high_float-grid' \
         with yerrorbars title 'over float-grid' lc rgb blue pt 7, \
       file using (int($0) % 12 + 0.2):(if_at(position, 'time_ratio_float')):'low_float':'high_float' \
         with yerrorbars title 'over float' lc rgb orange pt 7
}
unset multiplot
