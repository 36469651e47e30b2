# Copyright the limpet authors. GPL-3.0-or-later.
# Time per point and memory against the length of the stream.
#   gnuplot -e "folder='out/bench'" benchmarks/plots/streams.gp
load 'benchmarks/plots/style.gp'
file = folder.'/streams.csv'
of(shape) = strcol('shape') eq shape ? column('points') : NaN
sofar(y) = column('ns_per_point') > 0 ? column(y) : NaN  # not the row after finishing
set terminal pngcairo size 1000,460 font 'sans,10'
set output folder.'/streams.png'
set multiplot layout 1,2
set logscale xy
set format y '%g'
set format x '10^{%L}'
set xlabel 'points in the stream'
set key outside bottom center horizontal maxcols 2 Left reverse
set title 'Time per point, µs'
plot file using (of('cube')):(column('ns_per_point') / 1000) title 'cube, from the start' lc rgb blue pt 7, \
     file using (of('cube')):(column('ns_per_point_since_last') / 1000) title 'cube, since the last mark' lc rgb blue dt 2 pt 6, \
     file using (of('city:100')):(column('ns_per_point') / 1000) title 'city of 100, from the start' lc rgb orange pt 7, \
     file using (of('city:100')):(column('ns_per_point_since_last') / 1000) title 'city of 100, since the last mark' lc rgb orange dt 2 pt 6
set title 'Peak memory, MB'
plot file using (of('cube')):(sofar('megabytes')) title 'cube' lc rgb blue pt 7, \
     file using (of('city:100')):(sofar('megabytes')) title 'city of 100' lc rgb orange pt 7
unset multiplot
