# Copyright the limpet authors. GPL-3.0-or-later.
# What exactness costs in whole runs: median, smallest and largest ratio of processor time.
#   gnuplot -e "folder='out/predicates'" benchmarks/plots/predicates_runs.gp
load 'benchmarks/plots/style.gp'
set datafile columnheaders
file = folder.'/runs.csv'
set terminal pngcairo size 800,420 font 'sans,10'
set output folder.'/runs.png'
set title 'Whole runs: processor time, exact over float'
set bmargin 6
set key outside bottom center horizontal Left reverse
set offsets 0.5, 0.5, 0, 0
set yrange [0.7:3]
set logscale y
set ytics (0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.15, 1.3, 1.5, 1.75, 2, 2.5, 3)
of(build) = strcol('build') eq build ? column('time_ratio') : NaN
set arrow 1 from graph 0, first 1.15 to graph 1, first 1.15 nohead dt 2 lc rgb grey
set arrow 2 from graph 0, first 1 to graph 1, first 1 nohead lc rgb grey
plot file using (int($0 / 2) - 0.1):(of('float-grid')):'least':'largest':xtic(strcol('source').', '.strcol('regime')) \
       with yerrorbars title 'over float-grid' lc rgb blue pt 7, \
     file using (int($0 / 2) + 0.1):(of('float')):'least':'largest' \
       with yerrorbars title 'over float' lc rgb orange pt 7, \
     NaN with lines dt 2 lc rgb grey title '1.15'
