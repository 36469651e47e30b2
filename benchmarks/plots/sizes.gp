# Copyright the limpet authors. GPL-3.0-or-later.
# Time per point and memory against the number of faces, beside region growing.
#   gnuplot -e "folder='out/bench'" benchmarks/plots/sizes.gp
load 'benchmarks/plots/style.gp'
file = folder.'/sizes.csv'
by(name, order) = strcol('contestant') eq name && strcol('order') eq order ? column('true_faces') : NaN
set terminal pngcairo size 1000,460 font 'sans,10'
set output folder.'/sizes.png'
set multiplot layout 1,2
set logscale xy
set format y '%g'
set xrange [5:*]
set xlabel 'true faces'
set key outside bottom center horizontal maxcols 2 Left reverse
set title 'Time per point, µs'
plot file using (by('limpet', 'shuffled')):(column('ns_per_point') / 1000) title 'limpet, shuffled' lc rgb blue pt 7, \
     file using (by('limpet', 'raster')):(column('ns_per_point') / 1000) title 'limpet, raster' lc rgb blue dt 2 pt 6, \
     file using (by('region_growing', 'shuffled')):(column('ns_per_point') / 1000) title 'region growing, shuffled' lc rgb grey pt 5, \
     file using (by('region_growing', 'raster')):(column('ns_per_point') / 1000) title 'region growing, raster' lc rgb grey dt 2 pt 4
set title 'Peak memory, MB'
plot file using (by('limpet', 'shuffled')):'megabytes' title 'limpet, shuffled' lc rgb blue pt 7, \
     file using (by('limpet', 'raster')):'megabytes' title 'limpet, raster' lc rgb blue dt 2 pt 6, \
     file using (by('region_growing', 'shuffled')):'megabytes' title 'region growing' lc rgb grey pt 5
unset multiplot
