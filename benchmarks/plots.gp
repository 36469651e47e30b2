# Copyright the limpet authors. GPL-3.0-or-later.
# Pictures of a report's CSV files: gnuplot -e "folder='out/bench'" benchmarks/plots.gp
set datafile separator ','
set datafile missing NaN
set grid lw 0.5 lc rgb '#dddddd'
set border 3
set tics nomirror
set style data linespoints
set pointsize 0.9
blue = '#1f77b4'; orange = '#ff7f0e'; grey = '#7f7f7f'
set title font ',12'

# ---- Time per point and memory against the length of the stream
file = folder.'/streams.csv'
of(shape) = strcol('shape') eq shape && strcol('note') eq '' ? column('points') : NaN
set terminal pngcairo size 1000,420 font 'sans,10'
set output folder.'/streams.png'
set multiplot layout 1,2
set logscale x
set format x '10^{%L}'
set xlabel 'points in the stream'
set key top right Left reverse
set yrange [0:*]
set offsets graph 0, 0, graph 0.15, 0
set title 'Time per point, ns'
plot file using (of('cube')):'ns_per_point' title 'cube, from the start' lc rgb blue pt 7, \
     file using (of('cube')):'ns_per_point_since_last' title 'cube, since the last mark' lc rgb blue dt 2 pt 6, \
     file using (of('city:100')):'ns_per_point' title 'city of 100, from the start' lc rgb orange pt 7, \
     file using (of('city:100')):'ns_per_point_since_last' title 'city of 100, since the last mark' lc rgb orange dt 2 pt 6
set title 'Peak memory, MB'
plot file using (of('cube')):'megabytes' title 'cube' lc rgb blue pt 7, \
     file using (of('city:100')):'megabytes' title 'city of 100' lc rgb orange pt 7
unset multiplot

# ---- Against the number of faces, beside region growing
file = folder.'/sizes.csv'
by(name, order) = strcol('contestant') eq name && strcol('order') eq order ? column('true_faces') : NaN
set terminal pngcairo size 1000,420 font 'sans,10'
set output folder.'/sizes.png'
set multiplot layout 1,2
set xlabel 'true faces'
set key top left Left reverse
set title 'Time per point, µs'
plot file using (by('limpet', 'shuffled')):(column('ns_per_point') / 1000) title 'limpet, shuffled' lc rgb blue pt 7, \
     file using (by('limpet', 'raster')):(column('ns_per_point') / 1000) title 'limpet, raster' lc rgb blue dt 2 pt 6, \
     file using (by('region_growing', 'shuffled')):(column('ns_per_point') / 1000) title 'region growing, shuffled' lc rgb grey pt 5, \
     file using (by('region_growing', 'raster')):(column('ns_per_point') / 1000) title 'region growing, raster' lc rgb grey dt 2 pt 4
set logscale y
set yrange [*:*]
set format y '%g'
set title 'Peak memory, MB'
plot file using (by('limpet', 'shuffled')):'megabytes' title 'limpet, shuffled' lc rgb blue pt 7, \
     file using (by('limpet', 'raster')):'megabytes' title 'limpet, raster' lc rgb blue dt 2 pt 6, \
     file using (by('region_growing', 'shuffled')):'megabytes' title 'region growing' lc rgb grey pt 5
unset multiplot
