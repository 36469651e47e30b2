# Copyright the limpet authors. GPL-3.0-or-later.
# What random operations break in the float builds.
#   gnuplot -e "folder='out/predicates'" benchmarks/plots/predicates_laws.gp
load 'benchmarks/plots/style.gp'
set datafile columnheaders
file = folder.'/laws.csv'
set terminal pngcairo size 800,420 font 'sans,10'
set output folder.'/laws.png'
set title 'Of 1000 random operations, how many broke a law, threw, hung or crashed'
set bmargin 6
set key outside bottom center horizontal Left reverse
set style fill solid 0.8 noborder
set boxwidth 0.25
set yrange [0:*]
broken = 'simple audit identity untouched area sides contains exception hangs crashes'
faults(x) = (sum [i = 1:words(broken)] column(word(broken, i))) * 1000.0 / column('operations')
of(build) = strcol('build') eq build ? faults(0) : NaN
set xtics ('general, grid' 0, 'general, free' 1, 'general, far' 2, \
           'degenerate, grid' 3, 'degenerate, free' 4, 'degenerate, far' 5)
set xrange [-0.5:5.5]
plot file using (int($0 / 3) - 0.26):(of('exact')) with boxes title 'exact' lc rgb grey, \
     file using (int($0 / 3)):(of('float-grid')) with boxes title 'float-grid' lc rgb blue, \
     file using (int($0 / 3) + 0.26):(of('float')) with boxes title 'float' lc rgb orange
